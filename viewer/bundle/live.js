/*! Contains three.js (MIT, three.js authors), uPlot (MIT, Leon Sorokin), lil-gui (MIT, George Michael Brower). */
(()=>{var dS="http://www.w3.org/2000/svg";function Om(n,t,e){for(let[i,s]of Object.entries(t))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):i==="style"?n.style.cssText=s:n.setAttribute(i,s===!0?"":s));return n.append(...e.filter(i=>i!=null)),n}var X=(n,t={},...e)=>Om(document.createElement(n),t,e),hn=(n,t={},...e)=>Om(document.createElementNS(dS,n),t,e);var Fm=new Set,Bm=()=>Fm.forEach(n=>n()),en=n=>getComputedStyle(document.documentElement).getPropertyValue(n.replace(/^var\(|\)$/g,"")).trim(),km=n=>Fm.add(n);function Um(n){document.documentElement.classList.toggle("printing",n),document.querySelectorAll("details").forEach(t=>{n&&(t.open=!0)}),Bm()}function zm(){matchMedia("(prefers-color-scheme: dark)").addEventListener("change",Bm),addEventListener("beforeprint",()=>Um(!0)),addEventListener("afterprint",()=>Um(!1))}var vr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},br={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Sg=0,Ud=1,wg=2;var Xs=1,Mg=2,Jo=3,Sr=0,li=1,an=2,Yr=0,Ko=1,Fd=2,Bd=3,kd=4,Eg=5;var Zr=100,Ag=101,Tg=102,Cg=103,Rg=104,Pg=200,Ig=201,Lg=202,Dg=203,zd=204,Gd=205,Ng=206,Og=207,Ug=208,Fg=209,Bg=210,kg=211,zg=212,Gg=213,Vg=214,Ac=0,Tc=1,Cc=2,zo=3,Rc=4,Pc=5,Ic=6,Lc=7,rh=0,Hg=1,Wg=2,ms=0,Vd=1,Hd=2,Wd=3,Xd=4,$d=5,qd=6,Yd=7;var Zd=300,jr=301,Qo=302,oh=303,ah=304,Dc=1e3,fs=1001,Nc=1002,Vn=1003,Xg=1004;var hl=1005;var ri=1006,lh=1007;var $s=1008;var fi=1009,jd=1010,Jd=1011,ta=1012,ch=1013,Ki=1014,Gi=1015,Qi=1016,hh=1017,uh=1018,Jr=1020,Kd=35902,Qd=35899,tf=1021,ef=1022,ts=1023,zs=1026,qs=1027,dh=1028,fh=1029,wr=1030,ph=1031;var mh=1033,ul=33776,dl=33777,fl=33778,pl=33779,gh=35840,_h=35841,xh=35842,yh=35843,vh=36196,bh=37492,Sh=37496,wh=37488,Mh=37489,ml=37490,Eh=37491,Ah=37808,Th=37809,Ch=37810,Rh=37811,Ph=37812,Ih=37813,Lh=37814,Dh=37815,Nh=37816,Oh=37817,Uh=37818,Fh=37819,Bh=37820,kh=37821,zh=36492,Gh=36494,Vh=36495,Hh=36283,Wh=36284,gl=36285,Xh=36286;var Ga=2300,Oc=2301,Mc=2302,Cd=2303,Rd=2400,Pd=2401,Id=2402;var $g=3200;var _l=0,qg=1,Ys="",bi="srgb",Va="srgb-linear",Ha="linear",Pe="srgb";var Ec=7680,nf=7681;var sf=517;var Yg=519,Zg=512,jg=513,Jg=514,rf=515,Kg=516,Qg=517,of=518,af=519,lf=35044,cf=35048;var hf="300 es",Oi=2e3,Go=2001;function fS(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function pS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Wa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function t0(){let n=Wa("canvas");return n.style.display="block",n}var Gm={},Vo=null;function Xa(...n){let t="THREE."+n.shift();Vo?Vo("log",t,...n):console.log(t,...n)}function e0(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Yt(...n){n=e0(n);let t="THREE."+n.shift();if(Vo)Vo("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ee(...n){n=e0(n);let t="THREE."+n.shift();if(Vo)Vo("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function ka(...n){let t=n.join(" ");t in Gm||(Gm[t]=!0,Yt(...n))}function n0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var i0={[Ac]:Ac,[Cc]:Ic,[Rc]:Rc,[zo]:Pc,[Tc]:Tc,[Ic]:Cc,[Lc]:Lc,[Pc]:zo},Ji=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Vm=1234567,Bo=Math.PI/180,Ho=180/Math.PI;function Mr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Zn[n&255]+Zn[n>>8&255]+Zn[n>>16&255]+Zn[n>>24&255]+"-"+Zn[t&255]+Zn[t>>8&255]+"-"+Zn[t>>16&15|64]+Zn[t>>24&255]+"-"+Zn[e&63|128]+Zn[e>>8&255]+"-"+Zn[e>>16&255]+Zn[e>>24&255]+Zn[i&255]+Zn[i>>8&255]+Zn[i>>16&255]+Zn[i>>24&255]).toLowerCase()}function ce(n,t,e){return Math.max(t,Math.min(e,n))}function uf(n,t){return(n%t+t)%t}function mS(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function gS(n,t,e){return n!==t?(e-n)/(t-n):0}function za(n,t,e){return(1-e)*n+e*t}function _S(n,t,e,i){return za(n,t,1-Math.exp(-e*i))}function xS(n,t=1){return t-Math.abs(uf(n,t*2)-t)}function yS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function vS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function bS(n,t){return n+Math.floor(Math.random()*(t-n+1))}function SS(n,t){return n+Math.random()*(t-n)}function wS(n){return n*(.5-Math.random())}function MS(n){n!==void 0&&(Vm=n);let t=Vm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function ES(n){return n*Bo}function AS(n){return n*Ho}function TS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function CS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function df(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function RS(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),d=r((t-i)/2),h=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:Yt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function $h(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ff(n,t){if(t.constructor===Float32Array)return n;let e=$h(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function pf(n,t){if(t.constructor===Float32Array)return n;let e=$h(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ea={DEG2RAD:Bo,RAD2DEG:Ho,generateUUID:Mr,clamp:ce,euclideanModulo:uf,mapLinear:mS,inverseLerp:gS,lerp:za,damp:_S,pingpong:xS,smoothstep:yS,smootherstep:vS,randInt:bS,randFloat:SS,randFloatSpread:wS,seededRandom:MS,degToRad:ES,radToDeg:AS,isPowerOfTwo:TS,ceilPowerOfTwo:CS,floorPowerOfTwo:df,setQuaternionFromProperEuler:RS,normalize:pf,denormalize:ff},yf=class yf{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};yf.prototype.isVector2=!0;var Wt=yf,Ie=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],p=r[o+2],g=r[o+3];if(d!==g||l!==h||c!==f||u!==p){let m=l*h+c*f+u*p+d*g;m<0&&(h=-h,f=-f,p=-p,g=-g,m=-m);let _=1-a;if(m<.9995){let x=Math.acos(m),S=Math.sin(x);_=Math.sin(_*x)/S,a=Math.sin(a*x)/S,l=l*_+h*a,c=c*_+f*a,u=u*_+p*a,d=d*_+g*a}else{l=l*_+h*a,c=c*_+f*a,u=u*_+p*a,d=d*_+g*a;let x=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=x,c*=x,u*=x,d*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*d+l*f-c*h,t[e+1]=l*p+u*h+c*d-a*f,t[e+2]=c*p+u*f+a*h-l*d,t[e+3]=u*p-a*d-l*h-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"YZX":this._x=h*u*d+c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d-h*f*p;break;case"XZY":this._x=h*u*d-c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d+h*f*p;break;default:Yt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],d=e[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},vf=class vf{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Hm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Hm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return rd.copy(this).projectOnVector(t),this.sub(rd)}reflect(t){return this.sub(rd.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};vf.prototype.isVector3=!0;var R=vf,rd=new R,Hm=new Ie,bf=class bf{constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],p=i[8],g=s[0],m=s[3],_=s[6],x=s[1],S=s[4],y=s[7],C=s[2],A=s[5],v=s[8];return r[0]=o*g+a*x+l*C,r[3]=o*m+a*S+l*A,r[6]=o*_+a*y+l*v,r[1]=c*g+u*x+d*C,r[4]=c*m+u*S+d*A,r[7]=c*_+u*y+d*v,r[2]=h*g+f*x+p*C,r[5]=h*m+f*S+p*A,r[8]=h*_+f*y+p*v,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,p=e*d+i*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let g=1/p;return t[0]=d*g,t[1]=(s*c-u*i)*g,t[2]=(a*i-s*o)*g,t[3]=h*g,t[4]=(u*e-s*l)*g,t[5]=(s*r-a*e)*g,t[6]=f*g,t[7]=(i*l-c*e)*g,t[8]=(o*e-i*r)*g,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return ka("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(od.makeScale(t,e)),this}rotate(t){return ka("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(od.makeRotation(-t)),this}translate(t,e){return ka("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(od.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};bf.prototype.isMatrix3=!0;var se=bf,od=new se,Wm=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Xm=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function PS(){let n={enabled:!0,workingColorSpace:Va,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=ks(s.r),s.g=ks(s.g),s.b=ks(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=ko(s.r),s.g=ko(s.g),s.b=ko(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ys?Ha:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Va]:{primaries:t,whitePoint:i,transfer:Ha,toXYZ:Wm,fromXYZ:Xm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:bi},outputColorSpaceConfig:{drawingBufferColorSpace:bi}},[bi]:{primaries:t,whitePoint:i,transfer:Pe,toXYZ:Wm,fromXYZ:Xm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:bi}}}),n}var ve=PS();function ks(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ko(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var So,Uc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{So===void 0&&(So=Wa("canvas")),So.width=t.width,So.height=t.height;let s=So.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=So}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Wa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ks(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ks(e[i]/255)*255):e[i]=ks(e[i]);return{data:e,width:t.width,height:t.height}}else return Yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},IS=0,Wo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:IS++}),this.uuid=Mr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ad(s[o].image)):r.push(ad(s[o]))}else r=ad(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function ad(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Uc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Yt("Texture: Unable to serialize Texture."),{})}var LS=0,ld=new R,ui=class n extends Ji{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=fs,s=fs,r=ri,o=$s,a=ts,l=fi,c=n.DEFAULT_ANISOTROPY,u=Ys){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:LS++}),this.uuid=Mr(),this.name="",this.source=new Wo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Wt(0,0),this.repeat=new Wt(1,1),this.center=new Wt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ld).x}get height(){return this.source.getSize(ld).y}get depth(){return this.source.getSize(ld).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Zd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Dc:t.x=t.x-Math.floor(t.x);break;case fs:t.x=t.x<0?0:1;break;case Nc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Dc:t.y=t.y-Math.floor(t.y);break;case fs:t.y=t.y<0?0:1;break;case Nc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ui.DEFAULT_IMAGE=null;ui.DEFAULT_MAPPING=Zd;ui.DEFAULT_ANISOTROPY=1;var Sf=class Sf{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],p=l[9],g=l[2],m=l[6],_=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-g)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+g)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+_-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,y=(f+1)/2,C=(_+1)/2,A=(u+h)/4,v=(d+g)/4,M=(p+m)/4;return S>y&&S>C?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=A/i,r=v/i):y>C?y<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(y),i=A/s,r=M/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=v/r,s=M/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(d-g)*(d-g)+(h-u)*(h-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(d-g)/x,this.z=(h-u)/x,this.w=Math.acos((c+f+_-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};Sf.prototype.isVector4=!0;var Le=Sf,Fc=class extends Ji{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Le(0,0,t,e),this.scissorTest=!1,this.viewport=new Le(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ui({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Wo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Mi=class extends Fc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},$a=class extends ui{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Vn,this.minFilter=Vn,this.wrapR=fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Bc=class extends ui{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Vn,this.minFilter=Vn,this.wrapR=fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var sh=class sh{constructor(t,e,i,s,r,o,a,l,c,u,d,h,f,p,g,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,d,h,f,p,g,m)}set(t,e,i,s,r,o,a,l,c,u,d,h,f,p,g,m){let _=this.elements;return _[0]=t,_[4]=e,_[8]=i,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=d,_[14]=h,_[3]=f,_[7]=p,_[11]=g,_[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new sh().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/wo.setFromMatrixColumn(t,0).length(),r=1/wo.setFromMatrixColumn(t,1).length(),o=1/wo.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let h=o*u,f=o*d,p=a*u,g=a*d;e[0]=l*u,e[4]=-l*d,e[8]=c,e[1]=f+p*c,e[5]=h-g*c,e[9]=-a*l,e[2]=g-h*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let h=l*u,f=l*d,p=c*u,g=c*d;e[0]=h+g*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=g+h*a,e[10]=o*l}else if(t.order==="ZXY"){let h=l*u,f=l*d,p=c*u,g=c*d;e[0]=h-g*a,e[4]=-o*d,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=g-h*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let h=o*u,f=o*d,p=a*u,g=a*d;e[0]=l*u,e[4]=p*c-f,e[8]=h*c+g,e[1]=l*d,e[5]=g*c+h,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let h=o*l,f=o*c,p=a*l,g=a*c;e[0]=l*u,e[4]=g-h*d,e[8]=p*d+f,e[1]=d,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*d+p,e[10]=h-g*d}else if(t.order==="XZY"){let h=o*l,f=o*c,p=a*l,g=a*c;e[0]=l*u,e[4]=-d,e[8]=c*u,e[1]=h*d+g,e[5]=o*u,e[9]=f*d-p,e[2]=p*d-f,e[6]=a*u,e[10]=g*d+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(DS,t,NS)}lookAt(t,e,i){let s=this.elements;return yi.subVectors(t,e),yi.lengthSq()===0&&(yi.z=1),yi.normalize(),lr.crossVectors(i,yi),lr.lengthSq()===0&&(Math.abs(i.z)===1?yi.x+=1e-4:yi.z+=1e-4,yi.normalize(),lr.crossVectors(i,yi)),lr.normalize(),Jl.crossVectors(yi,lr),s[0]=lr.x,s[4]=Jl.x,s[8]=yi.x,s[1]=lr.y,s[5]=Jl.y,s[9]=yi.y,s[2]=lr.z,s[6]=Jl.z,s[10]=yi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],p=i[2],g=i[6],m=i[10],_=i[14],x=i[3],S=i[7],y=i[11],C=i[15],A=s[0],v=s[4],M=s[8],U=s[12],P=s[1],L=s[5],F=s[9],G=s[13],N=s[2],z=s[6],Y=s[10],V=s[14],ot=s[3],$=s[7],K=s[11],et=s[15];return r[0]=o*A+a*P+l*N+c*ot,r[4]=o*v+a*L+l*z+c*$,r[8]=o*M+a*F+l*Y+c*K,r[12]=o*U+a*G+l*V+c*et,r[1]=u*A+d*P+h*N+f*ot,r[5]=u*v+d*L+h*z+f*$,r[9]=u*M+d*F+h*Y+f*K,r[13]=u*U+d*G+h*V+f*et,r[2]=p*A+g*P+m*N+_*ot,r[6]=p*v+g*L+m*z+_*$,r[10]=p*M+g*F+m*Y+_*K,r[14]=p*U+g*G+m*V+_*et,r[3]=x*A+S*P+y*N+C*ot,r[7]=x*v+S*L+y*z+C*$,r[11]=x*M+S*F+y*Y+C*K,r[15]=x*U+S*G+y*V+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],d=t[6],h=t[10],f=t[14],p=t[3],g=t[7],m=t[11],_=t[15],x=l*f-c*h,S=a*f-c*d,y=a*h-l*d,C=o*f-c*u,A=o*h-l*u,v=o*d-a*u;return e*(g*x-m*S+_*y)-i*(p*x-m*C+_*A)+s*(p*S-g*C+_*v)-r*(p*y-g*A+m*v)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],d=t[9],h=t[10],f=t[11],p=t[12],g=t[13],m=t[14],_=t[15],x=e*a-i*o,S=e*l-s*o,y=e*c-r*o,C=i*l-s*a,A=i*c-r*a,v=s*c-r*l,M=u*g-d*p,U=u*m-h*p,P=u*_-f*p,L=d*m-h*g,F=d*_-f*g,G=h*_-f*m,N=x*G-S*F+y*L+C*P-A*U+v*M;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let z=1/N;return t[0]=(a*G-l*F+c*L)*z,t[1]=(s*F-i*G-r*L)*z,t[2]=(g*v-m*A+_*C)*z,t[3]=(h*A-d*v-f*C)*z,t[4]=(l*P-o*G-c*U)*z,t[5]=(e*G-s*P+r*U)*z,t[6]=(m*y-p*v-_*S)*z,t[7]=(u*v-h*y+f*S)*z,t[8]=(o*F-a*P+c*M)*z,t[9]=(i*P-e*F-r*M)*z,t[10]=(p*A-g*y+_*x)*z,t[11]=(d*y-u*A-f*x)*z,t[12]=(a*U-o*L-l*M)*z,t[13]=(e*L-i*U+s*M)*z,t[14]=(g*S-p*C-m*x)*z,t[15]=(u*C-d*S+h*x)*z,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,p=r*d,g=o*u,m=o*d,_=a*d,x=l*c,S=l*u,y=l*d,C=i.x,A=i.y,v=i.z;return s[0]=(1-(g+_))*C,s[1]=(f+y)*C,s[2]=(p-S)*C,s[3]=0,s[4]=(f-y)*A,s[5]=(1-(h+_))*A,s[6]=(m+x)*A,s[7]=0,s[8]=(p+S)*v,s[9]=(m-x)*v,s[10]=(1-(h+g))*v,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=wo.set(s[0],s[1],s[2]).length(),a=wo.set(s[4],s[5],s[6]).length(),l=wo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Yi.copy(this);let c=1/o,u=1/a,d=1/l;return Yi.elements[0]*=c,Yi.elements[1]*=c,Yi.elements[2]*=c,Yi.elements[4]*=u,Yi.elements[5]*=u,Yi.elements[6]*=u,Yi.elements[8]*=d,Yi.elements[9]*=d,Yi.elements[10]*=d,e.setFromRotationMatrix(Yi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Oi,l=!1){let c=this.elements,u=2*r/(e-t),d=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s),p,g;if(l)p=r/(o-r),g=o*r/(o-r);else if(a===Oi)p=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Go)p=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=g,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Oi,l=!1){let c=this.elements,u=2/(e-t),d=2/(i-s),h=-(e+t)/(e-t),f=-(i+s)/(i-s),p,g;if(l)p=1/(o-r),g=o/(o-r);else if(a===Oi)p=-2/(o-r),g=-(o+r)/(o-r);else if(a===Go)p=-1/(o-r),g=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=g,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};sh.prototype.isMatrix4=!0;var Kt=sh,wo=new R,Yi=new Kt,DS=new R(0,0,0),NS=new R(1,1,1),lr=new R,Jl=new R,yi=new R,$m=new Kt,qm=new Ie,Ui=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ce(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return $m.makeRotationFromQuaternion(t),this.setFromRotationMatrix($m,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return qm.setFromEuler(this),this.setFromQuaternion(qm,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ui.DEFAULT_ORDER="XYZ";var Xo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},OS=0,Ym=new R,Mo=new Ie,Ds=new Kt,Kl=new R,La=new R,US=new R,FS=new Ie,Zm=new R(1,0,0),jm=new R(0,1,0),Jm=new R(0,0,1),Km={type:"added"},BS={type:"removed"},Eo={type:"childadded",child:null},cd={type:"childremoved",child:null},un=class n extends Ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:OS++}),this.uuid=Mr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new R,e=new Ui,i=new Ie,s=new R(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Kt},normalMatrix:{value:new se}}),this.matrix=new Kt,this.matrixWorld=new Kt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Xo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Mo.setFromAxisAngle(t,e),this.quaternion.multiply(Mo),this}rotateOnWorldAxis(t,e){return Mo.setFromAxisAngle(t,e),this.quaternion.premultiply(Mo),this}rotateX(t){return this.rotateOnAxis(Zm,t)}rotateY(t){return this.rotateOnAxis(jm,t)}rotateZ(t){return this.rotateOnAxis(Jm,t)}translateOnAxis(t,e){return Ym.copy(t).applyQuaternion(this.quaternion),this.position.add(Ym.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Zm,t)}translateY(t){return this.translateOnAxis(jm,t)}translateZ(t){return this.translateOnAxis(Jm,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ds.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Kl.copy(t):Kl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),La.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ds.lookAt(La,Kl,this.up):Ds.lookAt(Kl,La,this.up),this.quaternion.setFromRotationMatrix(Ds),s&&(Ds.extractRotation(s.matrixWorld),Mo.setFromRotationMatrix(Ds),this.quaternion.premultiply(Mo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ee("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Km),Eo.child=t,this.dispatchEvent(Eo),Eo.child=null):ee("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(BS),cd.child=t,this.dispatchEvent(cd),cd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ds.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ds.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ds),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Km),Eo.child=t,this.dispatchEvent(Eo),Eo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,t,US),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(La,FS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),d=o(t.shapes),h=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};un.DEFAULT_UP=new R(0,1,0);un.DEFAULT_MATRIX_AUTO_UPDATE=!0;un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ee=class extends un{constructor(){super(),this.isGroup=!0,this.type="Group"}},kS={type:"move"},$o=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ee,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ee,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new R,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new R),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ee,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new R,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new R,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let g of t.hand.values()){let m=e.getJointPose(g,i),_=this._getHandJoint(c,g);m!==null&&(_.matrix.fromArray(m.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=m.radius),_.visible=m!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&h>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&h<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(kS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ee;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},s0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},cr={h:0,s:0,l:0},Ql={h:0,s:0,l:0};function hd(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Zt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=bi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=i,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ve.workingColorSpace){if(t=uf(t,1),e=ce(e,0,1),i=ce(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=hd(o,r,t+1/3),this.g=hd(o,r,t),this.b=hd(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=bi){function i(r){r!==void 0&&parseFloat(r)<1&&Yt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Yt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=bi){let i=s0[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ks(t.r),this.g=ks(t.g),this.b=ks(t.b),this}copyLinearToSRGB(t){return this.r=ko(t.r),this.g=ko(t.g),this.b=ko(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=bi){return ve.workingToColorSpace(jn.copy(this),t),Math.round(ce(jn.r*255,0,255))*65536+Math.round(ce(jn.g*255,0,255))*256+Math.round(ce(jn.b*255,0,255))}getHexString(t=bi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(jn.copy(this),e);let i=jn.r,s=jn.g,r=jn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(jn.copy(this),e),t.r=jn.r,t.g=jn.g,t.b=jn.b,t}getStyle(t=bi){ve.workingToColorSpace(jn.copy(this),t);let e=jn.r,i=jn.g,s=jn.b;return t!==bi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(cr),this.setHSL(cr.h+t,cr.s+e,cr.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(cr),t.getHSL(Ql);let i=za(cr.h,Ql.h,e),s=za(cr.s,Ql.s,e),r=za(cr.l,Ql.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new Zt;Zt.NAMES=s0;var Vr=class extends un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ui,this.environmentIntensity=1,this.environmentRotation=new Ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Zi=new R,Ns=new R,ud=new R,Os=new R,Ao=new R,To=new R,Qm=new R,dd=new R,fd=new R,pd=new R,md=new Le,gd=new Le,_d=new Le,Bs=class n{constructor(t=new R,e=new R,i=new R){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Zi.subVectors(t,e),s.cross(Zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Zi.subVectors(s,e),Ns.subVectors(i,e),ud.subVectors(t,e);let o=Zi.dot(Zi),a=Zi.dot(Ns),l=Zi.dot(ud),c=Ns.dot(Ns),u=Ns.dot(ud),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Os)===null?!1:Os.x>=0&&Os.y>=0&&Os.x+Os.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Os.x),l.addScaledVector(o,Os.y),l.addScaledVector(a,Os.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return md.setScalar(0),gd.setScalar(0),_d.setScalar(0),md.fromBufferAttribute(t,e),gd.fromBufferAttribute(t,i),_d.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(md,r.x),o.addScaledVector(gd,r.y),o.addScaledVector(_d,r.z),o}static isFrontFacing(t,e,i,s){return Zi.subVectors(i,e),Ns.subVectors(t,e),Zi.cross(Ns).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Zi.subVectors(this.c,this.b),Ns.subVectors(this.a,this.b),Zi.cross(Ns).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Ao.subVectors(s,i),To.subVectors(r,i),dd.subVectors(t,i);let l=Ao.dot(dd),c=To.dot(dd);if(l<=0&&c<=0)return e.copy(i);fd.subVectors(t,s);let u=Ao.dot(fd),d=To.dot(fd);if(u>=0&&d<=u)return e.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Ao,o);pd.subVectors(t,r);let f=Ao.dot(pd),p=To.dot(pd);if(p>=0&&f<=p)return e.copy(r);let g=f*c-l*p;if(g<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(To,a);let m=u*p-f*d;if(m<=0&&d-u>=0&&f-p>=0)return Qm.subVectors(r,s),a=(d-u)/(d-u+(f-p)),e.copy(s).addScaledVector(Qm,a);let _=1/(m+g+h);return o=g*_,a=h*_,e.copy(i).addScaledVector(Ao,o).addScaledVector(To,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Be=class{constructor(t=new R(1/0,1/0,1/0),e=new R(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(ji.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(ji.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=ji.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ji):ji.fromBufferAttribute(r,o),ji.applyMatrix4(t.matrixWorld),this.expandByPoint(ji);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),tc.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),tc.copy(i.boundingBox)),tc.applyMatrix4(t.matrixWorld),this.union(tc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ji),ji.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Da),ec.subVectors(this.max,Da),Co.subVectors(t.a,Da),Ro.subVectors(t.b,Da),Po.subVectors(t.c,Da),hr.subVectors(Ro,Co),ur.subVectors(Po,Ro),Br.subVectors(Co,Po);let e=[0,-hr.z,hr.y,0,-ur.z,ur.y,0,-Br.z,Br.y,hr.z,0,-hr.x,ur.z,0,-ur.x,Br.z,0,-Br.x,-hr.y,hr.x,0,-ur.y,ur.x,0,-Br.y,Br.x,0];return!xd(e,Co,Ro,Po,ec)||(e=[1,0,0,0,1,0,0,0,1],!xd(e,Co,Ro,Po,ec))?!1:(nc.crossVectors(hr,ur),e=[nc.x,nc.y,nc.z],xd(e,Co,Ro,Po,ec))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ji).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ji).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Us),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Us=[new R,new R,new R,new R,new R,new R,new R,new R],ji=new R,tc=new Be,Co=new R,Ro=new R,Po=new R,hr=new R,ur=new R,Br=new R,Da=new R,ec=new R,nc=new R,kr=new R;function xd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){kr.fromArray(n,r);let a=s.x*Math.abs(kr.x)+s.y*Math.abs(kr.y)+s.z*Math.abs(kr.z),l=t.dot(kr),c=e.dot(kr),u=i.dot(kr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var An=new R,ic=new Wt,zS=0,Ze=class extends Ji{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:zS++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=lf,this.updateRanges=[],this.gpuType=Gi,this.version=0,this._normalizationScale=t!==void 0?$h(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)ic.fromBufferAttribute(this,e),ic.applyMatrix3(t),this.setXY(e,ic.x,ic.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.applyMatrix3(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.applyMatrix4(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.applyNormalMatrix(t),this.setXYZ(e,An.x,An.y,An.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.transformDirection(t),this.setXYZ(e,An.x,An.y,An.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):ff(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):pf(t,this.array)}};var qa=class extends Ze{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Ya=class extends Ze{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ie=class extends Ze{constructor(t,e,i){super(new Float32Array(t),e,i)}},GS=new Be,Na=new R,yd=new R,oi=class{constructor(t=new R,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):GS.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Na.subVectors(t,this.center);let e=Na.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Na,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(yd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Na.copy(t.center).add(yd)),this.expandByPoint(Na.copy(t.center).sub(yd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},VS=0,Ni=new Kt,vd=new un,Io=new R,vi=new Be,Oa=new Be,Gn=new R,we=class n extends Ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:VS++}),this.uuid=Mr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(fS(t)?Ya:qa)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new se().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ni.makeRotationFromQuaternion(t),this.applyMatrix4(Ni),this}rotateX(t){return Ni.makeRotationX(t),this.applyMatrix4(Ni),this}rotateY(t){return Ni.makeRotationY(t),this.applyMatrix4(Ni),this}rotateZ(t){return Ni.makeRotationZ(t),this.applyMatrix4(Ni),this}translate(t,e,i){return Ni.makeTranslation(t,e,i),this.applyMatrix4(Ni),this}scale(t,e,i){return Ni.makeScale(t,e,i),this.applyMatrix4(Ni),this}lookAt(t){return vd.lookAt(t),vd.updateMatrix(),this.applyMatrix4(vd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Io).negate(),this.translate(Io.x,Io.y,Io.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ie(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Be);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new R(-1/0,-1/0,-1/0),new R(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];vi.setFromBufferAttribute(r),this.morphTargetsRelative?(Gn.addVectors(this.boundingBox.min,vi.min),this.boundingBox.expandByPoint(Gn),Gn.addVectors(this.boundingBox.max,vi.max),this.boundingBox.expandByPoint(Gn)):(this.boundingBox.expandByPoint(vi.min),this.boundingBox.expandByPoint(vi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ee('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new oi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new R,1/0);return}if(t){let i=this.boundingSphere.center;if(vi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Oa.setFromBufferAttribute(a),this.morphTargetsRelative?(Gn.addVectors(vi.min,Oa.min),vi.expandByPoint(Gn),Gn.addVectors(vi.max,Oa.max),vi.expandByPoint(Gn)):(vi.expandByPoint(Oa.min),vi.expandByPoint(Oa.max))}vi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Gn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Gn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Gn.fromBufferAttribute(a,c),l&&(Io.fromBufferAttribute(t,c),Gn.add(Io)),s=Math.max(s,i.distanceToSquared(Gn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ee('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ee("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Ze(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new R,l[U]=new R;let u=new R,d=new R,h=new R,f=new Wt,p=new Wt,g=new Wt,m=new R,_=new R;function x(U,P,L){c[U]=c[P]=c[L]=1,u.fromBufferAttribute(i,U),d.fromBufferAttribute(i,P),h.fromBufferAttribute(i,L),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,P),g.fromBufferAttribute(r,L),d.sub(u),h.sub(u),p.sub(f),g.sub(f);let F=1/(p.x*g.y-g.x*p.y);isFinite(F)&&(m.copy(d).multiplyScalar(g.y).addScaledVector(h,-p.y).multiplyScalar(F),_.copy(h).multiplyScalar(p.x).addScaledVector(d,-g.x).multiplyScalar(F),a[U].add(m),a[P].add(m),a[L].add(m),l[U].add(_),l[P].add(_),l[L].add(_))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let U=0,P=S.length;U<P;++U){let L=S[U],F=L.start,G=L.count;for(let N=F,z=F+G;N<z;N+=3)x(t.getX(N+0),t.getX(N+1),t.getX(N+2))}let y=new R,C=new R,A=new R,v=new R;function M(U){A.fromBufferAttribute(s,U),v.copy(A);let P=a[U];y.copy(P),y.sub(A.multiplyScalar(A.dot(P))).normalize(),C.crossVectors(v,P);let F=C.dot(l[U])<0?-1:1;o.setXYZW(U,y.x,y.y,y.z,F)}for(let U=0,P=i.count;U<P;++U)c[U]&&M(U);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Ze(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new R,r=new R,o=new R,a=new R,l=new R,c=new R,u=new R,d=new R;if(t)for(let h=0,f=t.count;h<f;h+=3){let p=t.getX(h+0),g=t.getX(h+1),m=t.getX(h+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,g),o.fromBufferAttribute(e,m),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,g),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(g,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,f=e.count;h<f;h+=3)s.fromBufferAttribute(e,h+0),r.fromBufferAttribute(e,h+1),o.fromBufferAttribute(e,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Gn.fromBufferAttribute(t,e),Gn.normalize(),t.setXYZ(e,Gn.x,Gn.y,Gn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,p=0;for(let g=0,m=l.length;g<m;g++){a.isInterleavedBufferAttribute?f=l[g]*a.data.stride+a.offset:f=l[g]*u;for(let _=0;_<u;_++)h[p++]=c[f++]}return new Ze(h,u,d)}if(this.index===null)return Yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=t(h,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Za=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=lf,this.updateRanges=[],this.version=0,this.uuid=Mr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=tg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=tg(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function tg(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Mr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var si=new R,Fi=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?$h(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)si.fromBufferAttribute(this,e),si.applyMatrix4(t),this.setXYZ(e,si.x,si.y,si.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)si.fromBufferAttribute(this,e),si.applyNormalMatrix(t),this.setXYZ(e,si.x,si.y,si.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)si.fromBufferAttribute(this,e),si.transformDirection(t),this.setXYZ(e,si.x,si.y,si.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Xa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Ze(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Xa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):ff(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):pf(t,this.data.array)}},bd=new R,HS=new R,WS=new se,Si=class{constructor(t=new R(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=bd.subVectors(i,e).cross(HS.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(bd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||WS.getNormalMatrix(t),s=this.coplanarPoint(bd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},XS=0,ps=class extends Ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:XS++}),this.uuid=Mr(),this.name="",this.type="Material",this.blending=Ko,this.side=Sr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=zd,this.blendDst=Gd,this.blendEquation=Zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Zt(0,0,0),this.blendAlpha=0,this.depthFunc=zo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Yg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ec,this.stencilZFail=Ec,this.stencilZPass=Ec,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Yt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Si().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Wt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Wt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Fs=new R,Sd=new R,sc=new R,rc=new R,fr=class{constructor(t=new R,e=new R(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Fs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Fs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Fs.copy(this.origin).addScaledVector(this.direction,e),Fs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Sd.copy(t).add(e).multiplyScalar(.5),sc.copy(e).sub(t).normalize(),rc.copy(this.origin).sub(Sd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(sc),a=rc.dot(this.direction),l=-rc.dot(sc),c=rc.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*l-a,h=o*a-l,p=r*u,d>=0)if(h>=-p)if(h<=p){let g=1/u;d*=g,h*=g,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=p?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Sd).addScaledVector(sc,h),f}intersectSphere(t,e){if(t.radius<0)return null;Fs.subVectors(t.center,this.origin);let i=Fs.dot(this.direction),s=Fs.dot(Fs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(t.min.x-h.x)*c,s=(t.max.x-h.x)*c):(i=(t.max.x-h.x)*c,s=(t.min.x-h.x)*c),u>=0?(r=(t.min.y-h.y)*u,o=(t.max.y-h.y)*u):(r=(t.max.y-h.y)*u,o=(t.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-h.z)*d,l=(t.max.z-h.z)*d):(a=(t.max.z-h.z)*d,l=(t.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Fs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=t.x-o.x,h=t.y-o.y,f=t.z-o.z,p=e.x-o.x,g=e.y-o.y,m=e.z-o.z,_=i.x-o.x,x=i.y-o.y,S=i.z-o.z,y=Math.abs(l),C=Math.abs(c),A=Math.abs(u),v,M,U,P,L,F,G,N,z,Y,V,ot;if(y>=C&&y>=A?(U=l,F=d,z=p,ot=_,l>=0?(v=c,M=u,P=h,L=f,G=g,N=m,Y=x,V=S):(v=u,M=c,P=f,L=h,G=m,N=g,Y=S,V=x)):C>=A?(U=c,F=h,z=g,ot=x,c>=0?(v=u,M=l,P=f,L=d,G=m,N=p,Y=S,V=_):(v=l,M=u,P=d,L=f,G=p,N=m,Y=_,V=S)):(U=u,F=f,z=m,ot=S,u>=0?(v=l,M=c,P=d,L=h,G=p,N=g,Y=_,V=x):(v=c,M=l,P=h,L=d,G=g,N=p,Y=x,V=_)),U===0)return null;let $=v/U,K=M/U,et=1/U,ht=P-$*F,ut=L-K*F,Q=G-$*z,gt=N-K*z,yt=Y-$*ot,Ct=V-K*ot,wt=yt*gt-Ct*Q,Xt=ht*Ct-ut*yt,ae=Q*ut-gt*ht;if(s){if(wt<0||Xt<0||ae<0)return null}else if((wt<0||Xt<0||ae<0)&&(wt>0||Xt>0||ae>0))return null;let Vt=wt+Xt+ae;if(Vt===0)return null;let me=et*(wt*F+Xt*z+ae*ot);return(Vt>0?me<0:me>0)?null:this.at(me/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ai=class extends ps{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=rh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},eg=new Kt,zr=new fr,oc=new oi,ng=new R,ac=new R,lc=new R,cc=new R,wd=new R,hc=new R,ig=new R,uc=new R,mt=class extends un{constructor(t=new we,e=new ai){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){hc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(wd.fromBufferAttribute(d,t),o?hc.addScaledVector(wd,u):hc.addScaledVector(wd.sub(e),u))}e.add(hc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),oc.copy(i.boundingSphere),oc.applyMatrix4(r),zr.copy(t.ray).recast(t.near),!(oc.containsPoint(zr.origin)===!1&&(zr.intersectSphere(oc,ng)===null||zr.origin.distanceToSquared(ng)>(t.far-t.near)**2))&&(eg.copy(r).invert(),zr.copy(t.ray).applyMatrix4(eg),!(i.boundingBox!==null&&zr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,zr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,g=h.length;p<g;p++){let m=h[p],_=o[m.materialIndex],x=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let y=x,C=S;y<C;y+=3){let A=a.getX(y),v=a.getX(y+1),M=a.getX(y+2);s=dc(this,_,t,i,c,u,d,A,v,M),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),g=Math.min(a.count,f.start+f.count);for(let m=p,_=g;m<_;m+=3){let x=a.getX(m),S=a.getX(m+1),y=a.getX(m+2);s=dc(this,o,t,i,c,u,d,x,S,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,g=h.length;p<g;p++){let m=h[p],_=o[m.materialIndex],x=Math.max(m.start,f.start),S=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let y=x,C=S;y<C;y+=3){let A=y,v=y+1,M=y+2;s=dc(this,_,t,i,c,u,d,A,v,M),s&&(s.faceIndex=Math.floor(y/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),g=Math.min(l.count,f.start+f.count);for(let m=p,_=g;m<_;m+=3){let x=m,S=m+1,y=m+2;s=dc(this,o,t,i,c,u,d,x,S,y),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function $S(n,t,e,i,s,r,o,a){let l;if(t.side===li?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Sr,a),l===null)return null;uc.copy(a),uc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(uc);return c<e.near||c>e.far?null:{distance:c,point:uc.clone(),object:n}}function dc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ac),n.getVertexPosition(l,lc),n.getVertexPosition(c,cc);let u=$S(n,t,e,i,ac,lc,cc,ig);if(u){let d=new R;Bs.getBarycoord(ig,ac,lc,cc,d),s&&(u.uv=Bs.getInterpolatedAttribute(s,a,l,c,d,new Wt)),r&&(u.uv1=Bs.getInterpolatedAttribute(r,a,l,c,d,new Wt)),o&&(u.normal=Bs.getInterpolatedAttribute(o,a,l,c,d,new R),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new R,materialIndex:0};Bs.getNormal(ac,lc,cc,h.normal),u.face=h,u.barycoord=d}return u}var ja=class extends ui{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Vn,u=Vn,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qo=class extends Ze{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Lo=new Kt,sg=new Kt,fc=[],rg=new Be,qS=new Kt,Ua=new mt,Fa=new oi,Gs=class extends mt{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new qo(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,qS)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Be),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Lo),rg.copy(t.boundingBox).applyMatrix4(Lo),this.boundingBox.union(rg)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new oi),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Lo),Fa.copy(t.boundingSphere).applyMatrix4(Lo),this.boundingSphere.union(Fa)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Ua.geometry=this.geometry,Ua.material=this.material,Ua.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Fa.copy(this.boundingSphere),Fa.applyMatrix4(i),t.ray.intersectsSphere(Fa)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Lo),sg.multiplyMatrices(i,Lo),Ua.matrixWorld=sg,Ua.raycast(t,fc);for(let o=0,a=fc.length;o<a;o++){let l=fc[o];l.instanceId=r,l.object=this,e.push(l)}fc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new qo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new ja(new Float32Array(s*this.count),s,this.count,dh,Gi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Gr=new oi,YS=new Wt(.5,.5),pc=new R,pr=class{constructor(t=new Si,e=new Si,i=new Si,s=new Si,r=new Si,o=new Si){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Oi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],g=r[9],m=r[10],_=r[11],x=r[12],S=r[13],y=r[14],C=r[15];if(s[0].setComponents(c-o,f-u,_-p,C-x).normalize(),s[1].setComponents(c+o,f+u,_+p,C+x).normalize(),s[2].setComponents(c+a,f+d,_+g,C+S).normalize(),s[3].setComponents(c-a,f-d,_-g,C-S).normalize(),i)s[4].setComponents(l,h,m,y).normalize(),s[5].setComponents(c-l,f-h,_-m,C-y).normalize();else if(s[4].setComponents(c-l,f-h,_-m,C-y).normalize(),e===Oi)s[5].setComponents(c+l,f+h,_+m,C+y).normalize();else if(e===Go)s[5].setComponents(l,h,m,y).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Gr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Gr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Gr)}intersectsSprite(t){Gr.center.set(0,0,0);let e=YS.distanceTo(t.center);return Gr.radius=.7071067811865476+e,Gr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Gr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(pc.x=s.normal.x>0?t.max.x:t.min.x,pc.y=s.normal.y>0?t.max.y:t.min.y,pc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(pc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},og=new Kt,kc=class n{constructor(){this.coordinateSystem=Oi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];og.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new pr),i[s].setFromProjectionMatrix(og,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new pr),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Bi=class extends ps{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Zt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},zc=new R,Gc=new R,ag=new Kt,Ba=new fr,mc=new oi,Md=new R,lg=new R,Ei=class extends un{constructor(t=new we,e=new Bi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)zc.fromBufferAttribute(e,s-1),Gc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=zc.distanceTo(Gc);t.setAttribute("lineDistance",new ie(i,1))}else Yt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),mc.copy(i.boundingSphere),mc.applyMatrix4(s),mc.radius+=r,t.ray.intersectsSphere(mc)===!1)return;ag.copy(s).invert(),Ba.copy(t.ray).applyMatrix4(ag);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let g=f,m=p-1;g<m;g+=c){let _=u.getX(g),x=u.getX(g+1),S=gc(this,t,Ba,l,_,x,g);S&&e.push(S)}if(this.isLineLoop){let g=u.getX(p-1),m=u.getX(f),_=gc(this,t,Ba,l,g,m,p-1);_&&e.push(_)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let g=f,m=p-1;g<m;g+=c){let _=gc(this,t,Ba,l,g,g+1,g);_&&e.push(_)}if(this.isLineLoop){let g=gc(this,t,Ba,l,p-1,f,p-1);g&&e.push(g)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function gc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(zc.fromBufferAttribute(a,s),Gc.fromBufferAttribute(a,r),e.distanceSqToSegment(zc,Gc,Md,lg)>i)return;Md.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Md);if(!(c<t.near||c>t.far))return{distance:c,point:lg.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var cg=new R,hg=new R,Vs=class extends Ei{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)cg.fromBufferAttribute(e,s),hg.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+cg.distanceTo(hg);t.setAttribute("lineDistance",new ie(i,1))}else Yt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ja=class extends ui{constructor(t=[],e=jr,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Hs=class extends ui{constructor(t,e,i=Ki,s,r,o,a=Vn,l=Vn,c,u=zs,d=1){if(u!==zs&&u!==qs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Wo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ka=class extends Hs{constructor(t,e=Ki,i=jr,s,r,o=Vn,a=Vn,l,c=zs){let u={width:t,height:t,depth:1},d=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Qa=class extends ui{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},je=class n extends we{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ie(c,3)),this.setAttribute("normal",new ie(u,3)),this.setAttribute("uv",new ie(d,2));function p(g,m,_,x,S,y,C,A,v,M,U){let P=y/v,L=C/M,F=y/2,G=C/2,N=A/2,z=v+1,Y=M+1,V=0,ot=0,$=new R;for(let K=0;K<Y;K++){let et=K*L-G;for(let ht=0;ht<z;ht++){let ut=ht*P-F;$[g]=ut*x,$[m]=et*S,$[_]=N,c.push($.x,$.y,$.z),$[g]=0,$[m]=0,$[_]=A>0?1:-1,u.push($.x,$.y,$.z),d.push(ht/v),d.push(1-K/M),V+=1}}for(let K=0;K<M;K++)for(let et=0;et<v;et++){let ht=h+et+z*K,ut=h+et+z*(K+1),Q=h+(et+1)+z*(K+1),gt=h+(et+1)+z*K;l.push(ht,ut,gt),l.push(ut,Q,gt),ot+=6}a.addGroup(f,ot,U),f+=ot,h+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Hr=class n extends we{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],u=e/2,d=Math.PI/2*t,h=e,f=2*d+h,p=i*2+r,g=s+1,m=new R,_=new R;for(let x=0;x<=p;x++){let S=0,y=0,C=0,A=0;if(x<=i){let U=x/i,P=U*Math.PI/2;y=-u-t*Math.cos(P),C=t*Math.sin(P),A=-t*Math.cos(P),S=U*d}else if(x<=i+r){let U=(x-i)/r;y=-u+U*e,C=t,A=0,S=d+U*h}else{let U=(x-i-r)/i,P=U*Math.PI/2;y=u+t*Math.sin(P),C=t*Math.cos(P),A=t*Math.sin(P),S=d+h+U*d}let v=Math.max(0,Math.min(1,S/f)),M=0;x===0?M=.5/s:x===p&&(M=-.5/s);for(let U=0;U<=s;U++){let P=U/s,L=P*Math.PI*2,F=Math.sin(L),G=Math.cos(L);_.x=-C*G,_.y=y,_.z=C*F,a.push(_.x,_.y,_.z),m.set(-C*G,A,C*F),m.normalize(),l.push(m.x,m.y,m.z),c.push(P+M,v)}if(x>0){let U=(x-1)*g;for(let P=0;P<s;P++){let L=U+P,F=U+P+1,G=x*g+P,N=x*g+P+1;o.push(L,F,G),o.push(F,N,G)}}}this.setIndex(o),this.setAttribute("position",new ie(a,3)),this.setAttribute("normal",new ie(l,3)),this.setAttribute("uv",new ie(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}};var Ve=class n extends we{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],p=0,g=[],m=i/2,_=0;x(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(u),this.setAttribute("position",new ie(d,3)),this.setAttribute("normal",new ie(h,3)),this.setAttribute("uv",new ie(f,2));function x(){let y=new R,C=new R,A=0,v=(e-t)/i;for(let M=0;M<=r;M++){let U=[],P=M/r,L=P*(e-t)+t;for(let F=0;F<=s;F++){let G=F/s,N=G*l+a,z=Math.sin(N),Y=Math.cos(N);C.x=L*z,C.y=-P*i+m,C.z=L*Y,d.push(C.x,C.y,C.z),y.set(z,v,Y).normalize(),h.push(y.x,y.y,y.z),f.push(G,1-P),U.push(p++)}g.push(U)}for(let M=0;M<s;M++)for(let U=0;U<r;U++){let P=g[U][M],L=g[U+1][M],F=g[U+1][M+1],G=g[U][M+1];(t>0||U!==0)&&(u.push(P,L,G),A+=3),(e>0||U!==r-1)&&(u.push(L,F,G),A+=3)}c.addGroup(_,A,0),_+=A}function S(y){let C=p,A=new Wt,v=new R,M=0,U=y===!0?t:e,P=y===!0?1:-1;for(let F=1;F<=s;F++)d.push(0,m*P,0),h.push(0,P,0),f.push(.5,.5),p++;let L=p;for(let F=0;F<=s;F++){let N=F/s*l+a,z=Math.cos(N),Y=Math.sin(N);v.x=U*Y,v.y=m*P,v.z=U*z,d.push(v.x,v.y,v.z),h.push(0,P,0),A.x=z*.5+.5,A.y=Y*.5*P+.5,f.push(A.x,A.y),p++}for(let F=0;F<s;F++){let G=C+F,N=L+F;y===!0?u.push(N,N+1,G):u.push(N+1,N,G),M+=3}c.addGroup(_,M,y===!0?1:2),_+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},ki=class n extends Ve{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Vc=class n extends we{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),u(),this.setAttribute("position",new ie(r,3)),this.setAttribute("normal",new ie(r.slice(),3)),this.setAttribute("uv",new ie(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let S=new R,y=new R,C=new R;for(let A=0;A<e.length;A+=3)f(e[A+0],S),f(e[A+1],y),f(e[A+2],C),l(S,y,C,x)}function l(x,S,y,C){let A=C+1,v=[];for(let M=0;M<=A;M++){v[M]=[];let U=x.clone().lerp(y,M/A),P=S.clone().lerp(y,M/A),L=A-M;for(let F=0;F<=L;F++)F===0&&M===A?v[M][F]=U:v[M][F]=U.clone().lerp(P,F/L)}for(let M=0;M<A;M++)for(let U=0;U<2*(A-M)-1;U++){let P=Math.floor(U/2);U%2===0?(h(v[M][P+1]),h(v[M+1][P]),h(v[M][P])):(h(v[M][P+1]),h(v[M+1][P+1]),h(v[M+1][P]))}}function c(x){let S=new R;for(let y=0;y<r.length;y+=3)S.x=r[y+0],S.y=r[y+1],S.z=r[y+2],S.normalize().multiplyScalar(x),r[y+0]=S.x,r[y+1]=S.y,r[y+2]=S.z}function u(){let x=new R;for(let S=0;S<r.length;S+=3){x.x=r[S+0],x.y=r[S+1],x.z=r[S+2];let y=m(x)/2/Math.PI+.5,C=_(x)/Math.PI+.5;o.push(y,1-C)}p(),d()}function d(){for(let x=0;x<o.length;x+=6){let S=o[x+0],y=o[x+2],C=o[x+4],A=Math.max(S,y,C),v=Math.min(S,y,C);A>.9&&v<.1&&(S<.2&&(o[x+0]+=1),y<.2&&(o[x+2]+=1),C<.2&&(o[x+4]+=1))}}function h(x){r.push(x.x,x.y,x.z)}function f(x,S){let y=x*3;S.x=t[y+0],S.y=t[y+1],S.z=t[y+2]}function p(){let x=new R,S=new R,y=new R,C=new R,A=new Wt,v=new Wt,M=new Wt;for(let U=0,P=0;U<r.length;U+=9,P+=6){x.set(r[U+0],r[U+1],r[U+2]),S.set(r[U+3],r[U+4],r[U+5]),y.set(r[U+6],r[U+7],r[U+8]),A.set(o[P+0],o[P+1]),v.set(o[P+2],o[P+3]),M.set(o[P+4],o[P+5]),C.copy(x).add(S).add(y).divideScalar(3);let L=m(C);g(A,P+0,x,L),g(v,P+2,S,L),g(M,P+4,y,L)}}function g(x,S,y,C){C<0&&x.x===1&&(o[S]=x.x-1),y.x===0&&y.z===0&&(o[S]=C/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function _(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var _c=new R,xc=new R,Ed=new R,yc=new Bs,tl=class extends we{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Bo*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],d=new Array(3),h=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:g,b:m,c:_}=yc;if(g.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),_.fromBufferAttribute(a,c[2]),yc.getNormal(Ed),d[0]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,d[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,d[2]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let x=0;x<3;x++){let S=(x+1)%3,y=d[x],C=d[S],A=yc[u[x]],v=yc[u[S]],M=`${y}_${C}`,U=`${C}_${y}`,P=h.get(U);P?(Ed.dot(P.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(v.x,v.y,v.z)),h.set(U,null)):h.has(M)||h.set(M,{index0:c[x],index1:c[S],normal:Ed.clone()})}}for(let p of h.values())if(p){let{index0:g,index1:m}=p;_c.fromBufferAttribute(a,g),xc.fromBufferAttribute(a,m),f.push(_c.x,_c.y,_c.z),f.push(xc.x,xc.y,xc.z)}this.setAttribute("position",new ie(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var mr=class n extends Vc{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Wr=class n extends we{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=t/a,h=e/l,f=[],p=[],g=[],m=[];for(let _=0;_<u;_++){let x=_*h-o;for(let S=0;S<c;S++){let y=S*d-r;p.push(y,-x,0),g.push(0,0,1),m.push(S/a),m.push(1-_/l)}}for(let _=0;_<l;_++)for(let x=0;x<a;x++){let S=x+c*_,y=x+c*(_+1),C=x+1+c*(_+1),A=x+1+c*_;f.push(S,y,A),f.push(y,C,A)}this.setIndex(f),this.setAttribute("position",new ie(p,3)),this.setAttribute("normal",new ie(g,3)),this.setAttribute("uv",new ie(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}},Xr=class n extends we{constructor(t=.5,e=1,i=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:i,phiSegments:s,thetaStart:r,thetaLength:o},i=Math.max(3,i),s=Math.max(1,s);let a=[],l=[],c=[],u=[],d=t,h=(e-t)/s,f=new R,p=new Wt;for(let g=0;g<=s;g++){for(let m=0;m<=i;m++){let _=r+m/i*o;f.x=d*Math.cos(_),f.y=d*Math.sin(_),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/e+1)/2,p.y=(f.y/e+1)/2,u.push(p.x,p.y)}d+=h}for(let g=0;g<s;g++){let m=g*(i+1);for(let _=0;_<i;_++){let x=_+m,S=x,y=x+i+1,C=x+i+2,A=x+1;a.push(S,y,A),a.push(y,C,A)}}this.setIndex(a),this.setAttribute("position",new ie(l,3)),this.setAttribute("normal",new ie(c,3)),this.setAttribute("uv",new ie(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var di=class n extends we{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],d=new R,h=new R,f=[],p=[],g=[],m=[];for(let _=0;_<=i;_++){let x=[],S=_/i,y=o+S*a,C=t*Math.cos(y),A=Math.sqrt(t*t-C*C),v=0;_===0&&o===0?v=.5/e:_===i&&l===Math.PI&&(v=-.5/e);for(let M=0;M<=e;M++){let U=M/e,P=s+U*r;d.x=-A*Math.cos(P),d.y=C,d.z=A*Math.sin(P),p.push(d.x,d.y,d.z),h.copy(d).normalize(),g.push(h.x,h.y,h.z),m.push(U+v,1-S),x.push(c++)}u.push(x)}for(let _=0;_<i;_++)for(let x=0;x<e;x++){let S=u[_][x+1],y=u[_][x],C=u[_+1][x],A=u[_+1][x+1];(_!==0||o>0)&&f.push(S,y,A),(_!==i-1||l<Math.PI)&&f.push(y,C,A)}this.setIndex(f),this.setAttribute("position",new ie(p,3)),this.setAttribute("normal",new ie(g,3)),this.setAttribute("uv",new ie(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ai=class n extends we{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],u=[],d=[],h=new R,f=new R,p=new R;for(let g=0;g<=i;g++){let m=o+g/i*a;for(let _=0;_<=s;_++){let x=_/s*r;f.x=(t+e*Math.cos(m))*Math.cos(x),f.y=(t+e*Math.cos(m))*Math.sin(x),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),h.x=t*Math.cos(x),h.y=t*Math.sin(x),p.subVectors(f,h).normalize(),u.push(p.x,p.y,p.z),d.push(_/s),d.push(g/i)}}for(let g=1;g<=i;g++)for(let m=1;m<=s;m++){let _=(s+1)*g+m-1,x=(s+1)*(g-1)+m-1,S=(s+1)*(g-1)+m,y=(s+1)*g+m;l.push(_,x,y),l.push(x,S,y)}this.setIndex(l),this.setAttribute("position",new ie(c,3)),this.setAttribute("normal",new ie(u,3)),this.setAttribute("uv",new ie(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};var el=class extends we{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,s=new R,r=new R;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let d=l[c],h=d.start,f=d.count;for(let p=h,g=h+f;p<g;p+=3)for(let m=0;m<3;m++){let _=a.getX(p+m),x=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,_),r.fromBufferAttribute(o,x),ug(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,d),ug(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new ie(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function ug(n,t,e){let i=`${n.x},${n.y},${n.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${n.x},${n.y},${n.z}`;return e.has(i)===!0||e.has(s)===!0?!1:(e.add(i),e.add(s),!0)}function Kr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(dg(s))s.isRenderTargetTexture?(Yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(dg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Kn(n){let t={};for(let e=0;e<n.length;e++){let i=Kr(n[e]);for(let s in i)t[s]=i[s]}return t}function dg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function ZS(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function mf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var xl={clone:Kr,merge:Kn},jS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,JS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,zi=class extends ps{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=jS,this.fragmentShader=JS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Kr(t.uniforms),this.uniformsGroups=ZS(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Zt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Wt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new R().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Le().fromArray(s.value);break;case"m3":this.uniforms[i].value=new se().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Kt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Hc=class extends zi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},nl=class extends ps{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Zt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=_l,this.normalScale=new Wt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Jn=class extends ps{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=_l,this.normalScale=new Wt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ui,this.combine=rh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Wc=class extends ps{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=$g,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Xc=class extends ps{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Do(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function vc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var gr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},$c=class extends gr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Rd,endingEnd:Rd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Pd:r=t,a=2*e-i;break;case Id:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Pd:o=t,l=2*i-e;break;case Id:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),g=p*p,m=g*p,_=-h*m+2*h*g-h*p,x=(1+h)*m+(-1.5-2*h)*g+(-.5+h)*p+1,S=(-1-f)*m+(1.5+f)*g+.5*p,y=f*m-f*g;for(let C=0;C!==a;++C)r[C]=_*o[u+C]+x*o[c+C]+S*o[l+C]+y*o[d+C];return r}},qc=class extends gr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Yc=class extends gr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Zc=class extends gr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(i-e)/(s-e),g=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*g+o[l+m]*p;return r}let h=a*2,f=t-1;for(let p=0;p!==a;++p){let g=o[c+p],m=o[l+p],_=f*h+p*2,x=d[_],S=d[_+1],y=t*h+p*2,C=u[y],A=u[y+1],v=QS(i,e,x,C,s);r[p]=r0(v,g,S,A,m)}return r}};function r0(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function KS(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function QS(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=r0(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=KS(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ti=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Do(e,this.TimeBufferType),this.values=Do(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Do(t.times,Array),values:Do(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),vc(t.settings)&&(i.settings={inTangents:Do(t.settings.inTangents,Array),outTangents:Do(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Yc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new qc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new $c(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Zc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Ga:e=this.InterpolantFactoryMethodDiscrete;break;case Oc:e=this.InterpolantFactoryMethodLinear;break;case Mc:e=this.InterpolantFactoryMethodSmooth;break;case Cd:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Yt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ga;case this.InterpolantFactoryMethodLinear:return Oc;case this.InterpolantFactoryMethodSmooth:return Mc;case this.InterpolantFactoryMethodBezier:return Cd}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;vc(this.settings)&&(fg(this.settings.inTangents,t),fg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;vc(this.settings)&&(pg(this.settings.inTangents,t),pg(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ee("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ee("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ee("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ee("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&pS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ee("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Mc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let p=0;p!==i;++p){let g=e[d+p];if(g!==e[h+p]||g!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)e[h+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,vc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function fg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function pg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Ti.prototype.ValueTypeName="";Ti.prototype.TimeBufferType=Float32Array;Ti.prototype.ValueBufferType=Float32Array;Ti.prototype.DefaultInterpolation=Oc;var _r=class extends Ti{constructor(t,e,i){super(t,e,i)}};_r.prototype.ValueTypeName="bool";_r.prototype.ValueBufferType=Array;_r.prototype.DefaultInterpolation=Ga;_r.prototype.InterpolantFactoryMethodLinear=void 0;_r.prototype.InterpolantFactoryMethodSmooth=void 0;var jc=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}};jc.prototype.ValueTypeName="color";var Jc=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}};Jc.prototype.ValueTypeName="number";var Kc=class extends gr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)Ie.slerpFlat(r,0,o,c-a,o,c,l);return r}},il=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Kc(this.times,this.values,this.getValueSize(),t)}};il.prototype.ValueTypeName="quaternion";il.prototype.InterpolantFactoryMethodSmooth=void 0;var xr=class extends Ti{constructor(t,e,i){super(t,e,i)}};xr.prototype.ValueTypeName="string";xr.prototype.ValueBufferType=Array;xr.prototype.DefaultInterpolation=Ga;xr.prototype.InterpolantFactoryMethodLinear=void 0;xr.prototype.InterpolantFactoryMethodSmooth=void 0;var Qc=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}};Qc.prototype.ValueTypeName="vector";var th=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},o0=new th,eh=class{constructor(t){this.manager=t!==void 0?t:o0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};eh.DEFAULT_MATERIAL_NAME="__DEFAULT";var sl=class extends un{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Zt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},rl=class extends sl{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Zt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Ad=new Kt,mg=new R,gg=new R,nh=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Wt(512,512),this.mapType=fi,this.map=null,this.mapPass=null,this.matrix=new Kt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new pr,this._frameExtents=new Wt(1,1),this._viewportCount=1,this._viewports=[new Le(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;mg.setFromMatrixPosition(t.matrixWorld),e.position.copy(mg),gg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(gg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Ad.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Ad,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Go||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Ad)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},bc=new R,Sc=new Ie,ds=new R,ol=class extends un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Kt,this.projectionMatrix=new Kt,this.projectionMatrixInverse=new Kt,this.coordinateSystem=Oi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(bc,Sc,ds),ds.x===1&&ds.y===1&&ds.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(bc,Sc,ds.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(bc,Sc,ds),ds.x===1&&ds.y===1&&ds.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(bc,Sc,ds.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},dr=new R,_g=new Wt,xg=new Wt,wi=class extends ol{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ho*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Bo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ho*2*Math.atan(Math.tan(Bo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){dr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(dr.x,dr.y).multiplyScalar(-t/dr.z),dr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(dr.x,dr.y).multiplyScalar(-t/dr.z)}getViewSize(t,e){return this.getViewBounds(t,_g,xg),e.subVectors(xg,_g)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Bo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var $r=class extends ol{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Ld=class extends nh{constructor(){super(new $r(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Yo=class extends sl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(un.DEFAULT_UP),this.updateMatrix(),this.target=new un,this.shadow=new Ld}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var al=class extends we{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var No=-90,Oo=1,Zo=class extends un{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new wi(No,Oo,t,e);s.layers=this.layers,this.add(s);let r=new wi(No,Oo,t,e);r.layers=this.layers,this.add(r);let o=new wi(No,Oo,t,e);o.layers=this.layers,this.add(o);let a=new wi(No,Oo,t,e);a.layers=this.layers,this.add(a);let l=new wi(No,Oo,t,e);l.layers=this.layers,this.add(l);let c=new wi(No,Oo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Oi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Go)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=t.getRenderTarget(),h=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let g=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=g,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(d,h,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},ih=class extends wi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var gf="\\[\\]\\.:\\/",tw=new RegExp("["+gf+"]","g"),_f="[^"+gf+"]",ew="[^"+gf.replace("\\.","")+"]",nw=/((?:WC+[\/:])*)/.source.replace("WC",_f),iw=/(WCOD+)?/.source.replace("WCOD",ew),sw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",_f),rw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",_f),ow=new RegExp("^"+nw+iw+sw+rw+"$"),aw=["material","materials","bones","map"],Dd=class{constructor(t,e,i){let s=i||nn.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},nn=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(tw,"")}static parseTrackName(t){let e=ow.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);aw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ee("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ee("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ee("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ee("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ee("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ee("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=Dd;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var IL=new Float32Array(1);var yr=class extends Za{constructor(t,e,i=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var yg=new Kt,Ws=class{constructor(t,e,i=0,s=1/0){this.ray=new fr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Xo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ee("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return yg.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(yg),this}intersectObject(t,e=!0,i=[]){return Nd(t,this,i,e),i.sort(vg),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Nd(t[s],this,i,e);return i.sort(vg),i}};function vg(n,t){return n.distance-t.distance}function Nd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Nd(r[o],t,e,!0)}}var jo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var wf=class wf{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};wf.prototype.isMatrix2=!0;var Od=wf;var bg=new R,wc=new R,Uo=new R,Fo=new R,Td=new R,lw=new R,cw=new R,ll=class{constructor(t=new R,e=new R){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){bg.subVectors(t,this.start),wc.subVectors(this.end,this.start);let i=wc.dot(wc);if(i===0)return 0;let r=wc.dot(bg)/i;return e&&(r=ce(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=lw,i=cw){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,u=t.end;Uo.subVectors(c,a),Fo.subVectors(u,l),Td.subVectors(a,l);let d=Uo.dot(Uo),h=Fo.dot(Fo),f=Fo.dot(Td);if(d<=s&&h<=s)return e.copy(a),i.copy(l),e.distanceToSquared(i);if(d<=s)r=0,o=f/h,o=ce(o,0,1);else{let p=Uo.dot(Td);if(h<=s)o=0,r=ce(-p/d,0,1);else{let g=Uo.dot(Fo),m=d*h-g*g;m!==0?r=ce((g*f-p*h)/m,0,1):r=0,o=(g*r+f)/h,o<0?(o=0,r=ce(-p/d,0,1)):o>1&&(o=1,r=ce((g-p)/d,0,1))}}return e.copy(a).addScaledVector(Uo,r),i.copy(l).addScaledVector(Fo,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var cl=class extends Vs{constructor(t=10,e=10,i=4473924,s=8947848){i=new Zt(i),s=new Zt(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let h=0,f=0,p=-a;h<=e;h++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let g=h===r?i:s;g.toArray(c,f),f+=3,g.toArray(c,f),f+=3,g.toArray(c,f),f+=3,g.toArray(c,f),f+=3}let u=new we;u.setAttribute("position",new ie(l,3)),u.setAttribute("color",new ie(c,3));let d=new Bi({vertexColors:!0,toneMapped:!1});super(u,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var qr=class extends Ji{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function xf(n,t,e,i){let s=hw(i);switch(e){case tf:return n*t;case dh:return n*t/s.components*s.byteLength;case fh:return n*t/s.components*s.byteLength;case wr:return n*t*2/s.components*s.byteLength;case ph:return n*t*2/s.components*s.byteLength;case ef:return n*t*3/s.components*s.byteLength;case ts:return n*t*4/s.components*s.byteLength;case mh:return n*t*4/s.components*s.byteLength;case ul:case dl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case fl:case pl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case _h:case yh:return Math.max(n,16)*Math.max(t,8)/4;case gh:case xh:return Math.max(n,8)*Math.max(t,8)/2;case vh:case bh:case wh:case Mh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Sh:case ml:case Eh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ah:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Th:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Ch:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Rh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Ph:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Ih:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Lh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Dh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Nh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Oh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Fh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Bh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case kh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case zh:case Gh:case Vh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Hh:case Wh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case gl:case Xh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function hw(n){switch(n){case fi:case jd:return{byteLength:1,components:1};case ta:case Jd:case Qi:return{byteLength:2,components:1};case hh:case uh:return{byteLength:2,components:4};case Ki:case ch:case Gi:return{byteLength:4,components:1};case Kd:case Qd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function C0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function mw(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],g=d[f];g.start<=p.start+p.count+1?p.count=Math.max(p.count,g.start+g.count-p.start):(++h,d[h]=g)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let g=d[f];n.bufferSubData(c,g.start*u.BYTES_PER_ELEMENT,u,g.start,g.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var gw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_w=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,xw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,yw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,vw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,bw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Sw=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ww=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Mw=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Ew=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Aw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Tw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Cw=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Rw=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Pw=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Iw=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Lw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Dw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Nw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ow=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Uw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Fw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Bw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,kw=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,zw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Gw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Vw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Hw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Ww=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Xw="gl_FragColor = linearToOutputTexel( gl_FragColor );",$w=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,qw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Yw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Zw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,jw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Jw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Kw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Qw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,tM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,eM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,nM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,iM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,sM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,rM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,oM=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,aM=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,lM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,cM=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uM=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,dM=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,fM=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,pM=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,mM=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,gM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,_M=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,xM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,yM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,bM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,SM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,wM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,MM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,EM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,AM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,TM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,CM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,RM=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,PM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,IM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,LM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,DM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,NM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,OM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,UM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,FM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,BM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,kM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,zM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,GM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,VM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,HM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,WM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,XM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$M=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,qM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,YM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ZM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,JM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,KM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,QM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,t1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,e1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,n1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,i1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,s1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,r1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,o1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,a1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,l1=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,c1=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,h1=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,u1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,d1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,f1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,p1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,m1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,g1=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,_1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,x1=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,y1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,v1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,b1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,S1=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,w1=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,M1=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,E1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,A1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,T1=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,C1=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,R1=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,P1=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,I1=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,L1=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,D1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,N1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,O1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,U1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,F1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,B1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,k1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,z1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,G1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,V1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,H1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,W1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,X1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,$1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,q1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Y1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pe={alphahash_fragment:gw,alphahash_pars_fragment:_w,alphamap_fragment:xw,alphamap_pars_fragment:yw,alphatest_fragment:vw,alphatest_pars_fragment:bw,aomap_fragment:Sw,aomap_pars_fragment:ww,batching_pars_vertex:Mw,batching_vertex:Ew,begin_vertex:Aw,beginnormal_vertex:Tw,bsdfs:Cw,iridescence_fragment:Rw,bumpmap_pars_fragment:Pw,clipping_planes_fragment:Iw,clipping_planes_pars_fragment:Lw,clipping_planes_pars_vertex:Dw,clipping_planes_vertex:Nw,color_fragment:Ow,color_pars_fragment:Uw,color_pars_vertex:Fw,color_vertex:Bw,common:kw,defaultnormal_vertex:zw,displacementmap_pars_vertex:Gw,displacementmap_vertex:Vw,emissivemap_fragment:Hw,emissivemap_pars_fragment:Ww,colorspace_fragment:Xw,colorspace_pars_fragment:$w,envmap_fragment:qw,envmap_common_pars_fragment:Yw,envmap_pars_fragment:Zw,envmap_pars_vertex:jw,envmap_physical_pars_fragment:aM,envmap_vertex:Jw,fog_vertex:Kw,fog_pars_vertex:Qw,fog_fragment:tM,fog_pars_fragment:eM,gradientmap_pars_fragment:nM,lightmap_pars_fragment:iM,lights_lambert_fragment:sM,lights_lambert_pars_fragment:rM,lights_pars_begin:oM,lights_toon_fragment:lM,lights_toon_pars_fragment:cM,lights_phong_fragment:hM,lights_phong_pars_fragment:uM,lights_physical_fragment:dM,lights_physical_pars_fragment:fM,lights_fragment_begin:pM,lights_fragment_maps:mM,lights_fragment_end:gM,lightprobes_pars_fragment:_M,logdepthbuf_fragment:xM,logdepthbuf_pars_fragment:yM,logdepthbuf_pars_vertex:vM,logdepthbuf_vertex:bM,map_fragment:SM,map_pars_fragment:wM,map_particle_fragment:MM,map_particle_pars_fragment:EM,metalnessmap_fragment:AM,metalnessmap_pars_fragment:TM,morphinstance_vertex:CM,morphcolor_vertex:RM,morphnormal_vertex:PM,morphtarget_pars_vertex:IM,morphtarget_vertex:LM,normal_fragment_begin:DM,normal_fragment_maps:NM,normal_pars_fragment:OM,normal_pars_vertex:UM,normal_vertex:FM,normalmap_pars_fragment:BM,clearcoat_normal_fragment_begin:kM,clearcoat_normal_fragment_maps:zM,clearcoat_pars_fragment:GM,iridescence_pars_fragment:VM,opaque_fragment:HM,packing:WM,premultiplied_alpha_fragment:XM,project_vertex:$M,dithering_fragment:qM,dithering_pars_fragment:YM,roughnessmap_fragment:ZM,roughnessmap_pars_fragment:jM,shadowmap_pars_fragment:JM,shadowmap_pars_vertex:KM,shadowmap_vertex:QM,shadowmask_pars_fragment:t1,skinbase_vertex:e1,skinning_pars_vertex:n1,skinning_vertex:i1,skinnormal_vertex:s1,specularmap_fragment:r1,specularmap_pars_fragment:o1,tonemapping_fragment:a1,tonemapping_pars_fragment:l1,transmission_fragment:c1,transmission_pars_fragment:h1,uv_pars_fragment:u1,uv_pars_vertex:d1,uv_vertex:f1,worldpos_vertex:p1,background_vert:m1,background_frag:g1,backgroundCube_vert:_1,backgroundCube_frag:x1,cube_vert:y1,cube_frag:v1,depth_vert:b1,depth_frag:S1,distance_vert:w1,distance_frag:M1,equirect_vert:E1,equirect_frag:A1,linedashed_vert:T1,linedashed_frag:C1,meshbasic_vert:R1,meshbasic_frag:P1,meshlambert_vert:I1,meshlambert_frag:L1,meshmatcap_vert:D1,meshmatcap_frag:N1,meshnormal_vert:O1,meshnormal_frag:U1,meshphong_vert:F1,meshphong_frag:B1,meshphysical_vert:k1,meshphysical_frag:z1,meshtoon_vert:G1,meshtoon_frag:V1,points_vert:H1,points_frag:W1,shadow_vert:X1,shadow_frag:$1,sprite_vert:q1,sprite_frag:Y1},It={common:{diffuse:{value:new Zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Wt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new Zt(16777215)},opacity:{value:1},center:{value:new Wt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},ci={basic:{uniforms:Kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:pe.meshbasic_vert,fragmentShader:pe.meshbasic_frag},lambert:{uniforms:Kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new Zt(0)},envMapIntensity:{value:1}}]),vertexShader:pe.meshlambert_vert,fragmentShader:pe.meshlambert_frag},phong:{uniforms:Kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new Zt(0)},specular:{value:new Zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pe.meshphong_vert,fragmentShader:pe.meshphong_frag},standard:{uniforms:Kn([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new Zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag},toon:{uniforms:Kn([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new Zt(0)}}]),vertexShader:pe.meshtoon_vert,fragmentShader:pe.meshtoon_frag},matcap:{uniforms:Kn([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:pe.meshmatcap_vert,fragmentShader:pe.meshmatcap_frag},points:{uniforms:Kn([It.points,It.fog]),vertexShader:pe.points_vert,fragmentShader:pe.points_frag},dashed:{uniforms:Kn([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pe.linedashed_vert,fragmentShader:pe.linedashed_frag},depth:{uniforms:Kn([It.common,It.displacementmap]),vertexShader:pe.depth_vert,fragmentShader:pe.depth_frag},normal:{uniforms:Kn([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:pe.meshnormal_vert,fragmentShader:pe.meshnormal_frag},sprite:{uniforms:Kn([It.sprite,It.fog]),vertexShader:pe.sprite_vert,fragmentShader:pe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pe.background_vert,fragmentShader:pe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:pe.backgroundCube_vert,fragmentShader:pe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pe.cube_vert,fragmentShader:pe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pe.equirect_vert,fragmentShader:pe.equirect_frag},distance:{uniforms:Kn([It.common,It.displacementmap,{referencePosition:{value:new R},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pe.distance_vert,fragmentShader:pe.distance_frag},shadow:{uniforms:Kn([It.lights,It.fog,{color:{value:new Zt(0)},opacity:{value:1}}]),vertexShader:pe.shadow_vert,fragmentShader:pe.shadow_frag}};ci.physical={uniforms:Kn([ci.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Wt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new Zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Wt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new Zt(0)},specularColor:{value:new Zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Wt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:pe.meshphysical_vert,fragmentShader:pe.meshphysical_frag};var qh={r:0,b:0,g:0},Z1=new Kt,R0=new se;R0.set(-1,0,0,0,1,0,0,0,1);function j1(n,t,e,i,s,r){let o=new Zt(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(x){let S=x.isScene===!0?x.background:null;if(S&&S.isTexture){let y=x.backgroundBlurriness>0;S=t.get(S,y)}return S}function p(x){let S=!1,y=f(x);y===null?m(o,a):y&&y.isColor&&(m(y,1),S=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function g(x,S){let y=f(S);y&&y.isCubeTexture?(c===void 0&&(c=new mt(new je(1,1,1),new zi({name:"BackgroundCubeMaterial",uniforms:Kr(ci.backgroundCube.uniforms),vertexShader:ci.backgroundCube.vertexShader,fragmentShader:ci.backgroundCube.fragmentShader,side:li,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=y,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Z1.makeRotationFromEuler(S.backgroundRotation)).transpose(),y.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(R0),c.material.toneMapped=ve.getTransfer(y.colorSpace)!==Pe,(u!==y||d!==y.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=y,d=y.version,h=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):y&&y.isTexture&&(l===void 0&&(l=new mt(new Wr(2,2),new zi({name:"BackgroundMaterial",uniforms:Kr(ci.background.uniforms),vertexShader:ci.background.vertexShader,fragmentShader:ci.background.fragmentShader,side:Sr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=y,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=ve.getTransfer(y.colorSpace)!==Pe,y.matrixAutoUpdate===!0&&y.updateMatrix(),l.material.uniforms.uvTransform.value.copy(y.matrix),(u!==y||d!==y.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=y,d=y.version,h=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,S){x.getRGB(qh,mf(n)),e.buffers.color.setClear(qh.r,qh.g,qh.b,S,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,S=1){o.set(x),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:g,dispose:_}}function J1(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,F,G,N,z){let Y=!1,V=d(L,N,G,F);r!==V&&(r=V,c(r.object)),Y=f(L,N,G,z),Y&&p(L,N,G,z),z!==null&&t.update(z,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,y(L,F,G,N),z!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(z).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function d(L,F,G,N){let z=N.wireframe===!0,Y=i[F.id];Y===void 0&&(Y={},i[F.id]=Y);let V=L.isInstancedMesh===!0?L.id:0,ot=Y[V];ot===void 0&&(ot={},Y[V]=ot);let $=ot[G.id];$===void 0&&($={},ot[G.id]=$);let K=$[z];return K===void 0&&(K=h(l()),$[z]=K),K}function h(L){let F=[],G=[],N=[];for(let z=0;z<e;z++)F[z]=0,G[z]=0,N[z]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:G,attributeDivisors:N,object:L,attributes:{},index:null}}function f(L,F,G,N){let z=r.attributes,Y=F.attributes,V=0,ot=G.getAttributes();for(let $ in ot)if(ot[$].location>=0){let et=z[$],ht=Y[$];if(ht===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(ht=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(ht=L.instanceColor)),et===void 0||et.attribute!==ht||ht&&et.data!==ht.data)return!0;V++}return r.attributesNum!==V||r.index!==N}function p(L,F,G,N){let z={},Y=F.attributes,V=0,ot=G.getAttributes();for(let $ in ot)if(ot[$].location>=0){let et=Y[$];et===void 0&&($==="instanceMatrix"&&L.instanceMatrix&&(et=L.instanceMatrix),$==="instanceColor"&&L.instanceColor&&(et=L.instanceColor));let ht={};ht.attribute=et,et&&et.data&&(ht.data=et.data),z[$]=ht,V++}r.attributes=z,r.attributesNum=V,r.index=N}function g(){let L=r.newAttributes;for(let F=0,G=L.length;F<G;F++)L[F]=0}function m(L){_(L,0)}function _(L,F){let G=r.newAttributes,N=r.enabledAttributes,z=r.attributeDivisors;G[L]=1,N[L]===0&&(n.enableVertexAttribArray(L),N[L]=1),z[L]!==F&&(n.vertexAttribDivisor(L,F),z[L]=F)}function x(){let L=r.newAttributes,F=r.enabledAttributes;for(let G=0,N=F.length;G<N;G++)F[G]!==L[G]&&(n.disableVertexAttribArray(G),F[G]=0)}function S(L,F,G,N,z,Y,V){V===!0?n.vertexAttribIPointer(L,F,G,z,Y):n.vertexAttribPointer(L,F,G,N,z,Y)}function y(L,F,G,N){g();let z=N.attributes,Y=G.getAttributes(),V=F.defaultAttributeValues;for(let ot in Y){let $=Y[ot];if($.location>=0){let K=z[ot];if(K===void 0&&(ot==="instanceMatrix"&&L.instanceMatrix&&(K=L.instanceMatrix),ot==="instanceColor"&&L.instanceColor&&(K=L.instanceColor)),K!==void 0){let et=K.normalized,ht=K.itemSize,ut=t.get(K);if(ut===void 0)continue;let Q=ut.buffer,gt=ut.type,yt=ut.bytesPerElement,Ct=gt===n.INT||gt===n.UNSIGNED_INT||K.gpuType===ch;if(K.isInterleavedBufferAttribute){let wt=K.data,Xt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,ae=K.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Vt=0;Vt<$.locationSize;Vt++)_($.location+Vt,wt.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Vt=0;Vt<$.locationSize;Vt++)m($.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Vt=0;Vt<$.locationSize;Vt++)S($.location+Vt,ht/$.locationSize,gt,et,Xt*yt,(ae+ht/$.locationSize*Vt)*yt,Ct)}else{if(K.isInstancedBufferAttribute){for(let wt=0;wt<$.locationSize;wt++)_($.location+wt,K.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let wt=0;wt<$.locationSize;wt++)m($.location+wt);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let wt=0;wt<$.locationSize;wt++)S($.location+wt,ht/$.locationSize,gt,et,ht*yt,ht/$.locationSize*wt*yt,Ct)}}else if(V!==void 0){let et=V[ot];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv($.location,et);break;case 3:n.vertexAttrib3fv($.location,et);break;case 4:n.vertexAttrib4fv($.location,et);break;default:n.vertexAttrib1fv($.location,et)}}}}x()}function C(){U();for(let L in i){let F=i[L];for(let G in F){let N=F[G];for(let z in N){let Y=N[z];for(let V in Y)u(Y[V].object),delete Y[V];delete N[z]}}delete i[L]}}function A(L){if(i[L.id]===void 0)return;let F=i[L.id];for(let G in F){let N=F[G];for(let z in N){let Y=N[z];for(let V in Y)u(Y[V].object),delete Y[V];delete N[z]}}delete i[L.id]}function v(L){for(let F in i){let G=i[F];for(let N in G){let z=G[N];if(z[L.id]===void 0)continue;let Y=z[L.id];for(let V in Y)u(Y[V].object),delete Y[V];delete z[L.id]}}}function M(L){for(let F in i){let G=i[F],N=L.isInstancedMesh===!0?L.id:0,z=G[N];if(z!==void 0){for(let Y in z){let V=z[Y];for(let ot in V)u(V[ot].object),delete V[ot];delete z[Y]}delete G[N],Object.keys(G).length===0&&delete i[F]}}}function U(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:M,releaseStatesOfProgram:v,initAttributes:g,enableAttribute:m,disableUnusedAttributes:x}}function K1(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];e.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Q1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let v=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==ts&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let M=v===Qi&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(v!==fi&&v!==Gi&&!M&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(Yt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),_=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),y=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:g,maxCubemapSize:m,maxAttributes:_,maxVertexUniforms:x,maxVaryings:S,maxFragmentUniforms:y,maxSamples:C,samples:A}}function tE(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Si,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){e=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,g=d.clipIntersection,m=d.clipShadows,_=n.get(d);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,S=x*4,y=_.clippingState||null;l.value=y,y=u(p,h,S,f);for(let C=0;C!==S;++C)y[C]=e[C];_.clippingState=y,this.numIntersection=g?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(d,h,f,p){let g=d!==null?d.length:0,m=null;if(g!==0){if(m=l.value,p!==!0||m===null){let _=f+g*4,x=h.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<_)&&(m=new Float32Array(_));for(let S=0,y=f;S!==g;++S,y+=4)o.copy(d[S]).applyMatrix4(x,a),o.normal.toArray(m,y),m[y+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=g,t.numIntersection=0,m}}var bl=class extends Mi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Ja(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new je(5,5,5),r=new zi({name:"CubemapFromEquirect",uniforms:Kr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:li,blending:Yr});r.uniforms.tEquirect.value=e;let o=new mt(s,r),a=e.minFilter;return e.minFilter===$s&&(e.minFilter=ri),new Zo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},a0=256,eE=3,nE=20,P0=256,I0=16,iE=3,sE=new R,rE=new Zt,Zh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Zo(1,10,null),this._boxMesh=new mt(new je(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=sE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,g=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,g===null&&(t.background=l.getClearColor(rE));let m=new Zo(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=p,t.background=g,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=h0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=c0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(a0,df(t))}_fromTexture(t,e){t.mapping===jr||t.mapping===Qo?this._setSize(t.image.length===0?a0:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=l0(t,!1,!1),i=Math.log2(t)-eE;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=l0(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===jr||t.mapping===Qo?(this._cubemapMaterial===null&&(this._cubemapMaterial=h0()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=c0()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=oE(),this._integrationMaterial=aE());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/I0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-iE)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(P0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=lE());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function l0(n,t,e){return new bl(n,{minFilter:$s,generateMipmaps:t,type:Qi,colorSpace:Va,depthBuffer:e})}function Sl(n,t,e){return new zi({name:n,uniforms:t,vertexShader:pe.cube_vert,fragmentShader:e,side:li,blending:Yr,depthTest:!1,depthWrite:!1})}function oE(){return Sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${P0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function aE(){return Sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:I0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function lE(){return Sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${nE}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function c0(){return Sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function h0(){return Sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function cE(n){let t=new WeakMap,e=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===oh||f===ah)if(t.has(h)){let p=t.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let g=new bl(p.height);return g.fromEquirectangularTexture(n,h),t.set(h,g),h.addEventListener("dispose",c),a(g.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,p=f===oh||f===ah,g=f===jr||f===Qo;if(p||g){let m=e.get(h),_=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==_)return i===null&&(i=new Zh(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),m.texture;if(m!==void 0)return m.texture;{let x=h.image;return p&&x&&x.height>0||g&&x&&l(x)?(i===null&&(i=new Zh(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,e.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,f){return f===oh?h.mapping=jr:f===ah&&(h.mapping=Qo),h}function l(h){let f=0,p=6;for(let g=0;g<p;g++)h[g]!==void 0&&f++;return f===p}function c(h){let f=h.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function hE(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&ka("WebGLRenderer: "+i+" extension not supported."),s}}}function uE(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let g=r.get(p);g&&(t.remove(g),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,g){return s[g.id]!==void 0||(g.addEventListener("dispose",a),s[g.id]=new WeakRef(g),o.register(g,g.id,g),e.memory.geometries++),g}function u(p){let g=p.attributes;for(let m in g)t.update(g[m],n.ARRAY_BUFFER)}function d(p){let g=p.index,m=p.attributes.position,_=0;if(m===void 0)return;let x=g!==null?g.array.length:m.array.length/3-1,S=m.count>=65535?Ya:qa,y=new S(Math.ceil(x/3)*6,1),C=y.array;if(g!==null){let v=g.array;_=g.version;for(let M=0,U=0;M<x;M+=3){let P=v[M+0],L=v[M+1],F=v[M+2];C[U++]=P,C[U++]=L,C[U++]=L,C[U++]=F,C[U++]=F,C[U++]=P}}else{_=m.version;for(let v=0,M=0;v<x;v+=3){let U=v+0,P=v+1,L=v+2;C[M++]=U,C[M++]=P,C[M++]=P,C[M++]=L,C[M++]=L,C[M++]=U}}y.version=_;let A=r.get(p);A&&t.remove(A),r.set(p,y)}function h(p){let g=r.get(p);if(g){let m=p.index;m!==null&&g.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let g=s[p].deref();g!==void 0&&l(g)}}return{get:c,update:u,getWireframeAttribute:h,dispose:f}}function dE(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),e.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),e.update(h,i,f))}function u(d,h,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let g=0;for(let m=0;m<f;m++)g+=h[m];e.update(g,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function fE(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ee("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function pE(n,t,e){let i=new WeakMap,s=new Le;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let U=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,g=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),g===!0&&(S=3);let y=a.attributes.position.count*S,C=1;y>t.maxTextureSize&&(C=Math.ceil(y/t.maxTextureSize),y=t.maxTextureSize);let A=new Float32Array(y*C*4*d),v=new $a(A,y,C,d);v.type=Gi,v.needsUpdate=!0;let M=S*4;for(let P=0;P<d;P++){let L=m[P],F=_[P],G=x[P],N=y*C*4*P;for(let z=0;z<L.count;z++){let Y=z*M;f===!0&&(s.fromBufferAttribute(L,z),A[N+Y+0]=s.x,A[N+Y+1]=s.y,A[N+Y+2]=s.z,A[N+Y+3]=0),p===!0&&(s.fromBufferAttribute(F,z),A[N+Y+4]=s.x,A[N+Y+5]=s.y,A[N+Y+6]=s.z,A[N+Y+7]=0),g===!0&&(s.fromBufferAttribute(G,z),A[N+Y+8]=s.x,A[N+Y+9]=s.y,A[N+Y+10]=s.z,A[N+Y+11]=G.itemSize===4?s.w:1)}}h={count:d,texture:v,size:new Wt(y,C)},i.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let g=0;g<c.length;g++)f+=c[g];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function mE(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=t.get(c,d);if(r.get(h)!==u&&(t.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var gE={[Vd]:"LINEAR_TONE_MAPPING",[Hd]:"REINHARD_TONE_MAPPING",[Wd]:"CINEON_TONE_MAPPING",[Xd]:"ACES_FILMIC_TONE_MAPPING",[qd]:"AGX_TONE_MAPPING",[Yd]:"NEUTRAL_TONE_MAPPING",[$d]:"CUSTOM_TONE_MAPPING"};function _E(n,t,e,i,s,r){let o=new Mi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new we;u.setAttribute("position",new ie([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ie([0,2,0,0,2,0],2));let d=new Hc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new mt(u,d),f=new $r(-1,1,1,-1,0,1),p=null,g=null,m=!1,_,x=null,S=[],y=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let v=0;v<S.length;v++){let M=S[v];M.setSize&&M.setSize(C,A)}},this.setEffects=function(C){S=C,y=S.length>0&&S[0].isRenderPass===!0;let A=o.width,v=o.height;S.length>0&&a===null&&(a=new Mi(A,v,{type:Qi,depthBuffer:!1,stencilBuffer:!1}),l=new Mi(A,v,{type:Qi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&S.some(U=>U.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Hs(A,v),r===!0&&(c.format=qs,c.type=Jr)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let U=0;U<S.length;U++){let P=S[U];P.setSize&&P.setSize(A,v),M&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,A){if(m||C.toneMapping===ms&&S.length===0)return!1;if(x=A,A!==null){let v=A.width,M=A.height;(o.width!==v||o.height!==M)&&this.setSize(v,M)}return y===!1&&C.setRenderTarget(o),_=C.toneMapping,C.toneMapping=ms,!0},this.hasRenderPass=function(){return y},this.end=function(C,A){C.toneMapping=_,m=!0;let v=o,M=a;for(let U=0;U<S.length;U++){let P=S[U];P.enabled!==!1&&(P.render(C,M,v,A),P.needsSwap!==!1&&(v=M,M=M===a?l:a))}if(p!==C.outputColorSpace||g!==C.toneMapping){p=C.outputColorSpace,g=C.toneMapping,d.defines={},ve.getTransfer(p)===Pe&&(d.defines.SRGB_TRANSFER="");let U=gE[g];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,C.setRenderTarget(x),C.render(h,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var L0=new ui,D0=new Hs(1,1),N0=new Ka(1),O0=new $a,U0=new Bc,F0=new Ja,u0=[],d0=[],f0=new Float32Array(16),p0=new Float32Array(9),m0=new Float32Array(4);function sa(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=u0[s];if(r===void 0&&(r=new Float32Array(s),u0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Pn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function In(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function jh(n,t){let e=d0[t];e===void 0&&(e=new Int32Array(t),d0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function xE(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function yE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pn(e,t))return;n.uniform2fv(this.addr,t),In(e,t)}}function vE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Pn(e,t))return;n.uniform3fv(this.addr,t),In(e,t)}}function bE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pn(e,t))return;n.uniform4fv(this.addr,t),In(e,t)}}function SE(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),In(e,t)}else{if(Pn(e,i))return;m0.set(i),n.uniformMatrix2fv(this.addr,!1,m0),In(e,i)}}function wE(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),In(e,t)}else{if(Pn(e,i))return;p0.set(i),n.uniformMatrix3fv(this.addr,!1,p0),In(e,i)}}function ME(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),In(e,t)}else{if(Pn(e,i))return;f0.set(i),n.uniformMatrix4fv(this.addr,!1,f0),In(e,i)}}function EE(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function AE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pn(e,t))return;n.uniform2iv(this.addr,t),In(e,t)}}function TE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Pn(e,t))return;n.uniform3iv(this.addr,t),In(e,t)}}function CE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pn(e,t))return;n.uniform4iv(this.addr,t),In(e,t)}}function RE(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function PE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pn(e,t))return;n.uniform2uiv(this.addr,t),In(e,t)}}function IE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Pn(e,t))return;n.uniform3uiv(this.addr,t),In(e,t)}}function LE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pn(e,t))return;n.uniform4uiv(this.addr,t),In(e,t)}}function Jh(n){return n.version===0&&(n.compareFunction=af,n.needsUpdate=!0),n}function DE(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Jh(D0):r=L0,e.setTexture2D(t||r,s)}function NE(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||U0,s)}function OE(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Jh(N0):r=F0,e.setTextureCube(t||r,s)}function UE(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||O0,s)}function FE(n){switch(n){case 5126:return xE;case 35664:return yE;case 35665:return vE;case 35666:return bE;case 35674:return SE;case 35675:return wE;case 35676:return ME;case 5124:case 35670:return EE;case 35667:case 35671:return AE;case 35668:case 35672:return TE;case 35669:case 35673:return CE;case 5125:return RE;case 36294:return PE;case 36295:return IE;case 36296:return LE;case 35678:case 36198:case 36298:case 36306:case 35682:return DE;case 35679:case 36299:case 36307:return NE;case 35680:case 36300:case 36308:case 36293:return OE;case 36289:case 36303:case 36311:case 36292:return UE}}function BE(n,t){n.uniform1fv(this.addr,t)}function kE(n,t){let e=sa(t,this.size,2);n.uniform2fv(this.addr,e)}function zE(n,t){let e=sa(t,this.size,3);n.uniform3fv(this.addr,e)}function GE(n,t){let e=sa(t,this.size,4);n.uniform4fv(this.addr,e)}function VE(n,t){let e=sa(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function HE(n,t){let e=sa(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function WE(n,t){let e=sa(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function XE(n,t){n.uniform1iv(this.addr,t)}function $E(n,t){n.uniform2iv(this.addr,t)}function qE(n,t){n.uniform3iv(this.addr,t)}function YE(n,t){n.uniform4iv(this.addr,t)}function ZE(n,t){n.uniform1uiv(this.addr,t)}function jE(n,t){n.uniform2uiv(this.addr,t)}function JE(n,t){n.uniform3uiv(this.addr,t)}function KE(n,t){n.uniform4uiv(this.addr,t)}function QE(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Jh(D0):o=L0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function tA(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||U0,r[o])}function eA(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Jh(N0):o=F0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function nA(n,t,e){let i=this.cache,s=t.length,r=jh(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||O0,r[o])}function iA(n){switch(n){case 5126:return BE;case 35664:return kE;case 35665:return zE;case 35666:return GE;case 35674:return VE;case 35675:return HE;case 35676:return WE;case 5124:case 35670:return XE;case 35667:case 35671:return $E;case 35668:case 35672:return qE;case 35669:case 35673:return YE;case 5125:return ZE;case 36294:return jE;case 36295:return JE;case 36296:return KE;case 35678:case 36198:case 36298:case 36306:case 35682:return QE;case 35679:case 36299:case 36307:return tA;case 35680:case 36300:case 36308:case 36293:return eA;case 36289:case 36303:case 36311:case 36292:return nA}}var Af=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=FE(e.type)}},Tf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=iA(e.type)}},Cf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Mf=/(\w+)(\])?(\[|\.)?/g;function g0(n,t){n.seq.push(t),n.map[t.id]=t}function sA(n,t,e){let i=n.name,s=i.length;for(Mf.lastIndex=0;;){let r=Mf.exec(i),o=Mf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){g0(e,c===void 0?new Af(a,n,t):new Tf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new Cf(a),g0(e,d)),e=d}}}var na=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);sA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function _0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var rA=37297,oA=0;function aA(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var x0=new se;function lA(n){ve._getMatrix(x0,ve.workingColorSpace,n);let t=`mat3( ${x0.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(n)){case Ha:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return Yt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function y0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+aA(n.getShaderSource(t),a)}else return r}function cA(n,t){let e=lA(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var hA={[Vd]:"Linear",[Hd]:"Reinhard",[Wd]:"Cineon",[Xd]:"ACESFilmic",[qd]:"AgX",[Yd]:"Neutral",[$d]:"Custom"};function uA(n,t){let e=hA[t];return e===void 0?(Yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Yh=new R;function dA(){ve.getLuminanceCoefficients(Yh);let n=Yh.x.toFixed(4),t=Yh.y.toFixed(4),e=Yh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function fA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(vl).join(`
`)}function pA(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function mA(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function vl(n){return n!==""}function v0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function b0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var gA=/^[ \t]*#include +<([\w\d./]+)>/gm;function Rf(n){return n.replace(gA,_A)}function _A(n,t){let e=pe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Rf(e)}var xA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function S0(n){return n.replace(xA,yA)}function yA(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function w0(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var vA={[Xs]:"SHADOWMAP_TYPE_PCF",[Jo]:"SHADOWMAP_TYPE_VSM"};function bA(n){return vA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var SA={[Qo]:"ENVMAP_MODE_REFRACTION"};function wA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":SA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var MA={[rh]:"ENVMAP_BLENDING_MULTIPLY",[Hg]:"ENVMAP_BLENDING_MIX",[Wg]:"ENVMAP_BLENDING_ADD"};function EA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":MA[n.combine]||"ENVMAP_BLENDING_NONE"}function AA(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=bA(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=wA(e),d=EA(e),h=fA(e),f=pA(r),p=s.createProgram(),g,m,_=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(vl).join(`
`),g.length>0&&(g+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(vl).join(`
`),m.length>0&&(m+=`
`)):(g=[w0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(vl).join(`
`),m=[w0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ms?"#define TONE_MAPPING":"",e.toneMapping!==ms?pe.tonemapping_pars_fragment:"",e.toneMapping!==ms?uA("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",pe.colorspace_pars_fragment,cA("linearToOutputTexel",e.outputColorSpace),dA(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(vl).join(`
`)),o=Rf(o),o=v0(o,e),o=b0(o,e),a=Rf(a),a=v0(a,e),a=b0(a,e),o=S0(o),a=S0(a),e.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,g=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+g,m=["#define varying in",e.glslVersion===hf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===hf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=_+g+o,S=_+m+a,y=_0(s,s.VERTEX_SHADER,x),C=_0(s,s.FRAGMENT_SHADER,S);s.attachShader(p,y),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function A(P){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(y)||"",G=s.getShaderInfoLog(C)||"",N=L.trim(),z=F.trim(),Y=G.trim(),V=!0,ot=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,y,C);else{let $=y0(s,y,"vertex"),K=y0(s,C,"fragment");ee("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+N+`
`+$+`
`+K)}else N!==""?Yt("WebGLProgram: Program Info Log:",N):(z===""||Y==="")&&(ot=!1);ot&&(P.diagnostics={runnable:V,programLog:N,vertexShader:{log:z,prefix:g},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(y),s.deleteShader(C),v=new na(s,p),M=mA(s,p)}let v;this.getUniforms=function(){return v===void 0&&A(this),v};let M;this.getAttributes=function(){return M===void 0&&A(this),M};let U=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,rA)),U},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=oA++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=y,this.fragmentShader=C,this}var TA=0,Pf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new If(t),e.set(t,i)),i}},If=class{constructor(t){this.id=TA++,this.code=t,this.usedTimes=0}};function CA(n){return n===wr||n===ml||n===gl}function RA(n,t,e,i,s,r){let o=new Xo,a=new Pf,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,M,U,P,L,F){let G=P.fog,N=L.geometry,z=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?P.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=t.get(v.envMap||z,Y),ot=h[v.type],$=i.precision;v.precision!==null&&($=i.getMaxPrecision(v.precision),$!==v.precision&&Yt("WebGLProgram.getParameters:",v.precision,"not supported, using",$,"instead."));let K=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,et=K!==void 0?K.length:0,ht=0;N.morphAttributes.position!==void 0&&(ht=1),N.morphAttributes.normal!==void 0&&(ht=2),N.morphAttributes.color!==void 0&&(ht=3);let ut,Q,gt,yt;if(ot){let Rt=ci[ot];ut=Rt.vertexShader,Q=Rt.fragmentShader}else{ut=v.vertexShader,Q=v.fragmentShader;let Rt=a.getVertexShaderStage(v),ue=a.getFragmentShaderStage(v);a.update(v,Rt,ue),gt=Rt.id,yt=ue.id}let Ct=n.getRenderTarget(),wt=n.state.buffers.depth.getReversed(),Xt=L.isInstancedMesh===!0,ae=L.isBatchedMesh===!0,Vt=!!v.map,me=!!v.matcap,de=!!V,re=de&&V.isPMREMTexture===!0,rn=!!v.aoMap,Ye=!!v.lightMap,vn=!!v.bumpMap&&v.wireframe===!1,ze=!!v.normalMap,Un=!!v.displacementMap,Se=!!v.emissiveMap,Cn=!!v.metalnessMap,dn=!!v.roughnessMap,bn=v.anisotropy>0,k=v.clearcoat>0,Pt=v.diffuseRoughness>0,jt=v.dispersion>0,le=v.retroreflectivity>0,Mt=v.iridescence>0,He=v.sheen>0,Gt=v.transmission>0,qt=bn&&!!v.anisotropyMap,I=k&&!!v.clearcoatMap,w=k&&!!v.clearcoatNormalMap,q=k&&!!v.clearcoatRoughnessMap,dt=Pt&&!!v.diffuseRoughnessMap,at=Mt&&!!v.iridescenceMap,xt=Mt&&!!v.iridescenceThicknessMap,vt=He&&!!v.sheenColorMap,nt=He&&!!v.sheenRoughnessMap,st=!!v.specularMap,pt=!!v.specularColorMap,B=!!v.specularIntensityMap,rt=Gt&&!!v.transmissionMap,it=Gt&&!!v.thicknessMap,Et=!!v.gradientMap,_t=!!v.alphaMap,St=v.alphaTest>0,Ht=!!v.alphaHash,Qt=!!v.extensions,ct=ms;v.toneMapped&&(Ct===null||Ct.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Bt=re?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,te={shaderID:ot,shaderType:v.type,shaderName:v.name,vertexShader:ut,fragmentShader:Q,defines:v.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:$,batching:ae,batchingColor:ae&&L._colorsTexture!==null,instancing:Xt,instancingColor:Xt&&L.instanceColor!==null,instancingMorph:Xt&&L.morphTexture!==null,outputColorSpace:Ct===null?n.outputColorSpace:Ct.isXRRenderTarget===!0?Ct.texture.colorSpace:ve.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Vt,matcap:me,envMap:de,envMapMode:de&&V.mapping,envMapPMREM:re,envMapMaxLod:re?Bt.length-1:null,envMapSize:re?Bt[0].width:null,aoMap:rn,lightMap:Ye,bumpMap:vn,normalMap:ze,displacementMap:Un,emissiveMap:Se,normalMapObjectSpace:ze&&v.normalMapType===qg,normalMapTangentSpace:ze&&v.normalMapType===_l,packedNormalMap:ze&&v.normalMapType===_l&&CA(v.normalMap.format),metalnessMap:Cn,roughnessMap:dn,anisotropy:bn,anisotropyMap:qt,clearcoat:k,clearcoatMap:I,clearcoatNormalMap:w,clearcoatRoughnessMap:q,diffuseRoughness:Pt,diffuseRoughnessMap:dt,dispersion:jt,retroreflection:le,iridescence:Mt,iridescenceMap:at,iridescenceThicknessMap:xt,sheen:He,sheenColorMap:vt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:pt,specularIntensityMap:B,transmission:Gt,transmissionMap:rt,thicknessMap:it,gradientMap:Et,opaque:v.transparent===!1&&v.blending===Ko&&v.alphaToCoverage===!1,alphaMap:_t,alphaTest:St,alphaHash:Ht,combine:v.combine,mapUv:Vt&&f(v.map.channel),aoMapUv:rn&&f(v.aoMap.channel),lightMapUv:Ye&&f(v.lightMap.channel),bumpMapUv:vn&&f(v.bumpMap.channel),normalMapUv:ze&&f(v.normalMap.channel),displacementMapUv:Un&&f(v.displacementMap.channel),emissiveMapUv:Se&&f(v.emissiveMap.channel),metalnessMapUv:Cn&&f(v.metalnessMap.channel),roughnessMapUv:dn&&f(v.roughnessMap.channel),anisotropyMapUv:qt&&f(v.anisotropyMap.channel),clearcoatMapUv:I&&f(v.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&f(v.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(v.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&f(v.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(v.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(v.sheenRoughnessMap.channel),specularMapUv:st&&f(v.specularMap.channel),specularColorMapUv:pt&&f(v.specularColorMap.channel),specularIntensityMapUv:B&&f(v.specularIntensityMap.channel),transmissionMapUv:rt&&f(v.transmissionMap.channel),thicknessMapUv:it&&f(v.thicknessMap.channel),alphaMapUv:_t&&f(v.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(ze||bn),vertexNormals:!!N.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!N.attributes.uv&&(Vt||_t),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||N.attributes.normal===void 0&&ze===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:wt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ht,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:F.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&v.map.isVideoTexture===!0&&ve.getTransfer(v.map.colorSpace)===Pe,decodeVideoTextureEmissive:Se&&v.emissiveMap.isVideoTexture===!0&&ve.getTransfer(v.emissiveMap.colorSpace)===Pe,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===an,flipSided:v.side===li,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Qt&&v.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&v.extensions.multiDraw===!0||ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function g(v){let M=[];if(v.shaderID?M.push(v.shaderID):(M.push(v.customVertexShaderID),M.push(v.customFragmentShaderID)),v.defines!==void 0)for(let U in v.defines)M.push(U),M.push(v.defines[U]);return v.isRawShaderMaterial===!1&&(m(M,v),_(M,v),M.push(n.outputColorSpace)),M.push(v.customProgramCacheKey),M.join()}function m(v,M){v.push(M.precision),v.push(M.outputColorSpace),v.push(M.envMapMode),v.push(M.envMapPMREM),v.push(M.envMapMaxLod),v.push(M.envMapSize),v.push(M.mapUv),v.push(M.alphaMapUv),v.push(M.lightMapUv),v.push(M.aoMapUv),v.push(M.bumpMapUv),v.push(M.normalMapUv),v.push(M.displacementMapUv),v.push(M.emissiveMapUv),v.push(M.metalnessMapUv),v.push(M.roughnessMapUv),v.push(M.anisotropyMapUv),v.push(M.clearcoatMapUv),v.push(M.clearcoatNormalMapUv),v.push(M.clearcoatRoughnessMapUv),v.push(M.diffuseRoughnessMapUv),v.push(M.iridescenceMapUv),v.push(M.iridescenceThicknessMapUv),v.push(M.sheenColorMapUv),v.push(M.sheenRoughnessMapUv),v.push(M.specularMapUv),v.push(M.specularColorMapUv),v.push(M.specularIntensityMapUv),v.push(M.transmissionMapUv),v.push(M.thicknessMapUv),v.push(M.combine),v.push(M.fogExp2),v.push(M.sizeAttenuation),v.push(M.morphTargetsCount),v.push(M.numSunLights),v.push(M.numDirLights),v.push(M.numPointLights),v.push(M.numSpotLights),v.push(M.numSpotLightMaps),v.push(M.numHemiLights),v.push(M.numRectAreaLights),v.push(M.numSunLightShadows),v.push(M.numDirLightShadows),v.push(M.numPointLightShadows),v.push(M.numSpotLightShadows),v.push(M.numSpotLightShadowsWithMaps),v.push(M.numLightProbes),v.push(M.numLightProbeGrids),v.push(M.shadowMapType),v.push(M.toneMapping),v.push(M.numClippingPlanes),v.push(M.numClipIntersection),v.push(M.depthPacking)}function _(v,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function x(v){let M=h[v.type],U;if(M){let P=ci[M];U=xl.clone(P.uniforms)}else U=v.uniforms;return U}function S(v,M){let U=u.get(M);return U!==void 0?++U.usedTimes:(U=new AA(n,M,v,s),c.push(U),u.set(M,U)),U}function y(v){if(--v.usedTimes===0){let M=c.indexOf(v);c[M]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function C(v){a.remove(v)}function A(){a.dispose()}return{getParameters:p,getProgramCacheKey:g,getUniforms:x,acquireProgram:S,releaseProgram:y,releaseShaderCache:C,programs:c,dispose:A}}function PA(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function IA(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function M0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function E0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,g,m,_){let x=n[t];return x===void 0?(x={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:g,renderOrder:h.renderOrder,z:m,group:_},n[t]=x):(x.id=h.id,x.object=h,x.geometry=f,x.material=p,x.materialVariant=o(h),x.groupOrder=g,x.renderOrder=h.renderOrder,x.z=m,x.group=_),t++,x}function l(h,f,p,g,m,_,x){x.reversedDepth===!0&&(m=-m);let S=a(h,f,p,g,m,_);p.transmission>0?i.push(S):p.transparent===!0?s.push(S):e.push(S)}function c(h,f,p,g,m,_){let x=a(h,f,p,g,m,_);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(h,f){e.length>1&&e.sort(h||IA),i.length>1&&i.sort(f||M0),s.length>1&&s.sort(f||M0)}function d(){for(let h=t,f=n.length;h<f;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function LA(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new E0,n.set(i,[o])):s>=r.length?(o=new E0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function DA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new R,color:new Zt};break;case"SpotLight":e={position:new R,direction:new R,color:new Zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new R,color:new Zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new R,skyColor:new Zt,groundColor:new Zt};break;case"RectAreaLight":e={color:new Zt,position:new R,halfWidth:new R,halfHeight:new R};break}return n[t.id]=e,e}}}function NA(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Wt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Wt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Wt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var OA=0;function UA(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function FA(n){let t=new DA,e=NA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new R);let s=new R,r=new Kt,o=new Kt;function a(c){let u=0,d=0,h=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,p=0,g=0,m=0,_=0,x=0,S=0,y=0,C=0,A=0,v=0,M=0,U=0,P=0;c.sort(UA);for(let F=0,G=c.length;F<G;F++){let N=c[F],z=N.color,Y=N.intensity,V=N.distance,ot=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===wr?ot=N.shadow.map.texture:ot=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=z.r*Y,d+=z.g*Y,h+=z.b*Y;else if(N.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(N.sh.coefficients[$],Y);P++}else if(N.isSunLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,et=e.get(N);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=ot;let ht=K.getViewportCount();for(let ut=0;ut<ht;ut++)i.sunShadowMatrix[g+ut]=K.getMatrix(ut),i.sunShadowCascade[g+ut]=K._cascadeData[ut];g+=ht,p++}i.sun[f]=$,f++}else if(N.isDirectionalLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let K=N.shadow,et=e.get(N);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize=K.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=ot,i.directionalShadowMatrix[m]=N.shadow.matrix,C++}i.directional[m]=$,m++}else if(N.isSpotLight){let $=t.get(N);$.position.setFromMatrixPosition(N.matrixWorld),$.color.copy(z).multiplyScalar(Y),$.distance=V,$.coneCos=Math.cos(N.angle),$.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),$.decay=N.decay,i.spot[x]=$;let K=N.shadow;if(N.map&&(i.spotLightMap[M]=N.map,M++,K.updateMatrices(N),N.castShadow&&U++),i.spotLightMatrix[x]=K.matrix,N.castShadow){let et=e.get(N);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize=K.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=ot,v++}x++}else if(N.isRectAreaLight){let $=t.get(N);$.color.copy(z).multiplyScalar(Y),$.halfWidth.set(N.width*.5,0,0),$.halfHeight.set(0,N.height*.5,0),i.rectArea[S]=$,S++}else if(N.isPointLight){let $=t.get(N);if($.color.copy(N.color).multiplyScalar(N.intensity),$.distance=N.distance,$.decay=N.decay,N.castShadow){let K=N.shadow,et=e.get(N);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize=K.mapSize,et.shadowCameraNear=K.camera.near,et.shadowCameraFar=K.camera.far,i.pointShadow[_]=et,i.pointShadowMap[_]=ot,i.pointShadowMatrix[_]=N.shadow.matrix,A++}i.point[_]=$,_++}else if(N.isHemisphereLight){let $=t.get(N);$.skyColor.copy(N.color).multiplyScalar(Y),$.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[y]=$,y++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=It.LTC_FLOAT_1,i.rectAreaLTC2=It.LTC_FLOAT_2):(i.rectAreaLTC1=It.LTC_HALF_1,i.rectAreaLTC2=It.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let L=i.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==_||L.spotLength!==x||L.rectAreaLength!==S||L.hemiLength!==y||L.numSunShadows!==p||L.numDirectionalShadows!==C||L.numPointShadows!==A||L.numSpotShadows!==v||L.numSpotMaps!==M||L.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=S,i.point.length=_,i.hemi.length=y,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=g,i.sunShadowCascade.length=g,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+M-U,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=P,L.sunLength=f,L.directionalLength=m,L.pointLength=_,L.spotLength=x,L.rectAreaLength=S,L.hemiLength=y,L.numSunShadows=p,L.numDirectionalShadows=C,L.numPointShadows=A,L.numSpotShadows=v,L.numSpotMaps=M,L.numLightProbes=P,i.version=OA++)}function l(c,u){let d=0,h=0,f=0,p=0,g=0,m=0,_=u.matrixWorldInverse;for(let x=0,S=c.length;x<S;x++){let y=c[x];if(y.isSunLight){let C=i.sun[d];C.direction.setFromMatrixPosition(y.matrixWorld),C.direction.transformDirection(_),d++}else if(y.isDirectionalLight){let C=i.directional[h];C.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(_),h++}else if(y.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(_),C.direction.setFromMatrixPosition(y.matrixWorld),s.setFromMatrixPosition(y.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(_),p++}else if(y.isRectAreaLight){let C=i.rectArea[g];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(_),o.identity(),r.copy(y.matrixWorld),r.premultiply(_),o.extractRotation(r),C.halfWidth.set(y.width*.5,0,0),C.halfHeight.set(0,y.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),g++}else if(y.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(y.matrixWorld),C.position.applyMatrix4(_),f++}else if(y.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(y.matrixWorld),C.direction.transformDirection(_),m++}}}return{setup:a,setupView:l,state:i}}function A0(n){let t=new FA(n),e=[],i=[],s=[];function r(d){u.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){t.setupView(e,d)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function BA(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new A0(n),t.set(s,[a])):r>=o.length?(a=new A0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var kA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,zA=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,GA=[new R(1,0,0),new R(-1,0,0),new R(0,1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1)],VA=[new R(0,-1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1),new R(0,-1,0),new R(0,-1,0)],T0=new Kt,yl=new R,Ef=new R;function HA(n,t,e){let i=new pr,s=new Wt,r=new Wt,o=new Le,a=new Wc,l=new Xc,c={},u=e.maxTextureSize,d={[Sr]:li,[li]:Sr,[an]:an},h=new zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Wt},radius:{value:4}},vertexShader:kA,fragmentShader:zA}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new we;p.setAttribute("position",new Ze(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let g=new mt(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xs;let _=this.type;this.render=function(A,v,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===Mg&&(Yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xs);let U=n.getRenderTarget(),P=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),F=n.state;F.setBlending(Yr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let G=_!==this.type;G&&v.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(z=>z.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,z=A.length;N<z;N++){let Y=A[N],V=Y.shadow;if(V===void 0){Yt("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ot=V.getFrameExtents();s.multiply(ot),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ot.x),s.x=r.x*ot.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ot.y),s.y=r.y*ot.y,V.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=$,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Jo){if(Y.isPointLight){Yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Mi(s.x,s.y,{format:wr,type:Qi,minFilter:ri,magFilter:ri,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new Hs(s.x,s.y,Gi),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=zs,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Vn,V.map.depthTexture.magFilter=Vn}else Y.isPointLight?(V.map=new bl(s.x),V.map.depthTexture=new Ka(s.x,Ki)):(V.map=new Mi(s.x,s.y),V.map.depthTexture=new Hs(s.x,s.y,Ki)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=zs,this.type===Xs?(V.map.depthTexture.compareFunction=$?of:rf,V.map.depthTexture.minFilter=ri,V.map.depthTexture.magFilter=ri):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Vn,V.map.depthTexture.magFilter=Vn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let K=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,M);let et=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:M.layers;for(let ht=0;ht<K;ht++){let ut=V.getCamera(ht);if(Y.isPointLight){let Q=V.camera,gt=V.matrix,yt=Y.distance||Q.far;yt!==Q.far&&(Q.far=yt,Q.updateProjectionMatrix()),yl.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(yl),Ef.copy(Q.position),Ef.add(GA[ht]),Q.up.copy(VA[ht]),Q.lookAt(Ef),Q.updateMatrixWorld(),gt.makeTranslation(-yl.x,-yl.y,-yl.z),T0.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),V._frustum.setFromProjectionMatrix(T0,Q.coordinateSystem,Q.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ht),n.clear();else{ht===0&&(n.setRenderTarget(V.map),n.clear());let Q=V.getViewport(ht);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),F.viewport(o)}i=V.getFrustum(ht),y(v,M,ut,Y,et,this.type)}V.isPointLightShadow!==!0&&this.type===Jo&&x(V,M),V.needsUpdate=!1}_=this.type,m.needsUpdate=!1,n.setRenderTarget(U,P,L)};function x(A,v){let M=t.update(g);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new Mi(s.x,s.y,{format:wr,type:Qi}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(v,null,M,h,g,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(v,null,M,f,g,null)}function S(A,v,M,U){let P=null,L=M.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)P=L;else if(P=M.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let F=P.uuid,G=v.uuid,N=c[F];N===void 0&&(N={},c[F]=N);let z=N[G];z===void 0&&(z=P.clone(),N[G]=z,v.addEventListener("dispose",C)),P=z}if(P.visible=v.visible,P.wireframe=v.wireframe,U===Jo?P.side=v.shadowSide!==null?v.shadowSide:v.side:P.side=v.shadowSide!==null?v.shadowSide:d[v.side],P.alphaMap=v.alphaMap,P.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,P.map=v.map,P.clipShadows=v.clipShadows,P.clippingPlanes=v.clippingPlanes,P.clipIntersection=v.clipIntersection,P.displacementMap=v.displacementMap,P.displacementScale=v.displacementScale,P.displacementBias=v.displacementBias,P.wireframeLinewidth=v.wireframeLinewidth,P.linewidth=v.linewidth,M.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=n.properties.get(P);F.light=M}return P}function y(A,v,M,U,P,L){if(A.visible===!1)return;if(A.layers.test(P)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===Jo)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,A.matrixWorld);let N=t.update(A),z=A.material;if(Array.isArray(z)){let Y=N.groups;for(let V=0,ot=Y.length;V<ot;V++){let $=Y[V],K=z[$.materialIndex];if(K&&K.visible){let et=S(A,K,U,L);A.onBeforeShadow(n,A,v,M,N,et,$),n.renderBufferDirect(M,null,N,et,A,$),A.onAfterShadow(n,A,v,M,N,et,$)}}}else if(z.visible){let Y=S(A,z,U,L);A.onBeforeShadow(n,A,v,M,N,Y,null),n.renderBufferDirect(M,null,N,Y,A,null),A.onAfterShadow(n,A,v,M,N,Y,null)}}let G=A.children;for(let N=0,z=G.length;N<z;N++)y(G[N],v,M,U,P,L)}function C(A){A.target.removeEventListener("dispose",C);for(let M in c){let U=c[M],P=A.target.uuid;P in U&&(U[P].dispose(),delete U[P])}}}function WA(n,t){function e(){let B=!1,rt=new Le,it=null,Et=new Le(0,0,0,0);return{setMask:function(_t){it!==_t&&!B&&(n.colorMask(_t,_t,_t,_t),it=_t)},setLocked:function(_t){B=_t},setClear:function(_t,St,Ht,Qt,ct){ct===!0&&(_t*=Qt,St*=Qt,Ht*=Qt),rt.set(_t,St,Ht,Qt),Et.equals(rt)===!1&&(n.clearColor(_t,St,Ht,Qt),Et.copy(rt))},reset:function(){B=!1,it=null,Et.set(-1,0,0,0)}}}function i(){let B=!1,rt=!1,it=null,Et=null,_t=null;return{setReversed:function(St){if(rt!==St){let Ht=t.get("EXT_clip_control");St?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=St;let Qt=_t;_t=null,this.setClear(Qt)}},getReversed:function(){return rt},setTest:function(St){St?wt(n.DEPTH_TEST):Xt(n.DEPTH_TEST)},setMask:function(St){it!==St&&!B&&(n.depthMask(St),it=St)},setFunc:function(St){if(rt&&(St=i0[St]),Et!==St){switch(St){case Ac:n.depthFunc(n.NEVER);break;case Tc:n.depthFunc(n.ALWAYS);break;case Cc:n.depthFunc(n.LESS);break;case zo:n.depthFunc(n.LEQUAL);break;case Rc:n.depthFunc(n.EQUAL);break;case Pc:n.depthFunc(n.GEQUAL);break;case Ic:n.depthFunc(n.GREATER);break;case Lc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=St}},setLocked:function(St){B=St},setClear:function(St){_t!==St&&(_t=St,rt&&(St=1-St),n.clearDepth(St))},reset:function(){B=!1,it=null,Et=null,_t=null,rt=!1}}}function s(){let B=!1,rt=null,it=null,Et=null,_t=null,St=null,Ht=null,Qt=null,ct=null;return{setTest:function(Bt){B||(Bt?wt(n.STENCIL_TEST):Xt(n.STENCIL_TEST))},setMask:function(Bt){rt!==Bt&&!B&&(n.stencilMask(Bt),rt=Bt)},setFunc:function(Bt,te,Rt){(it!==Bt||Et!==te||_t!==Rt)&&(n.stencilFunc(Bt,te,Rt),it=Bt,Et=te,_t=Rt)},setOp:function(Bt,te,Rt){(St!==Bt||Ht!==te||Qt!==Rt)&&(n.stencilOp(Bt,te,Rt),St=Bt,Ht=te,Qt=Rt)},setLocked:function(Bt){B=Bt},setClear:function(Bt){ct!==Bt&&(n.clearStencil(Bt),ct=Bt)},reset:function(){B=!1,rt=null,it=null,Et=null,_t=null,St=null,Ht=null,Qt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],g=null,m=!1,_=null,x=null,S=null,y=null,C=null,A=null,v=null,M=new Zt(0,0,0),U=0,P=!1,L=null,F=null,G=null,N=null,z=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ot=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ot=parseFloat(/^WebGL (\d)/.exec($)[1]),V=ot>=1):$.indexOf("OpenGL ES")!==-1&&(ot=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),V=ot>=2);let K=null,et={},ht=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),Q=new Le().fromArray(ht),gt=new Le().fromArray(ut);function yt(B,rt,it,Et){let _t=new Uint8Array(4),St=n.createTexture();n.bindTexture(B,St),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<it;Ht++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(rt+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return St}let Ct={};Ct[n.TEXTURE_2D]=yt(n.TEXTURE_2D,n.TEXTURE_2D,1),Ct[n.TEXTURE_CUBE_MAP]=yt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ct[n.TEXTURE_2D_ARRAY]=yt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ct[n.TEXTURE_3D]=yt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(n.DEPTH_TEST),o.setFunc(zo),vn(!1),ze(Ud),wt(n.CULL_FACE),rn(Yr);function wt(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function Xt(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function ae(B,rt){return h[B]!==rt?(n.bindFramebuffer(B,rt),h[B]=rt,B===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=rt),B===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(B,rt){let it=p,Et=!1;if(B){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let _t=B.textures;if(it.length!==_t.length||it[0]!==n.COLOR_ATTACHMENT0){for(let St=0,Ht=_t.length;St<Ht;St++)it[St]=n.COLOR_ATTACHMENT0+St;it.length=_t.length,Et=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Et=!0);Et&&n.drawBuffers(it)}function me(B){return g!==B?(n.useProgram(B),g=B,!0):!1}let de={[Zr]:n.FUNC_ADD,[Ag]:n.FUNC_SUBTRACT,[Tg]:n.FUNC_REVERSE_SUBTRACT};de[Cg]=n.MIN,de[Rg]=n.MAX;let re={[Pg]:n.ZERO,[Ig]:n.ONE,[Lg]:n.SRC_COLOR,[zd]:n.SRC_ALPHA,[Bg]:n.SRC_ALPHA_SATURATE,[Ug]:n.DST_COLOR,[Ng]:n.DST_ALPHA,[Dg]:n.ONE_MINUS_SRC_COLOR,[Gd]:n.ONE_MINUS_SRC_ALPHA,[Fg]:n.ONE_MINUS_DST_COLOR,[Og]:n.ONE_MINUS_DST_ALPHA,[kg]:n.CONSTANT_COLOR,[zg]:n.ONE_MINUS_CONSTANT_COLOR,[Gg]:n.CONSTANT_ALPHA,[Vg]:n.ONE_MINUS_CONSTANT_ALPHA};function rn(B,rt,it,Et,_t,St,Ht,Qt,ct,Bt){if(B===Yr){m===!0&&(Xt(n.BLEND),m=!1);return}if(m===!1&&(wt(n.BLEND),m=!0),B!==Eg){if(B!==_||Bt!==P){if((x!==Zr||C!==Zr)&&(n.blendEquation(n.FUNC_ADD),x=Zr,C=Zr),Bt)switch(B){case Ko:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Fd:n.blendFunc(n.ONE,n.ONE);break;case Bd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case kd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ee("WebGLState: Invalid blending: ",B);break}else switch(B){case Ko:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Fd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Bd:ee("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case kd:ee("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ee("WebGLState: Invalid blending: ",B);break}S=null,y=null,A=null,v=null,M.set(0,0,0),U=0,_=B,P=Bt}return}_t=_t||rt,St=St||it,Ht=Ht||Et,(rt!==x||_t!==C)&&(n.blendEquationSeparate(de[rt],de[_t]),x=rt,C=_t),(it!==S||Et!==y||St!==A||Ht!==v)&&(n.blendFuncSeparate(re[it],re[Et],re[St],re[Ht]),S=it,y=Et,A=St,v=Ht),(Qt.equals(M)===!1||ct!==U)&&(n.blendColor(Qt.r,Qt.g,Qt.b,ct),M.copy(Qt),U=ct),_=B,P=!1}function Ye(B,rt){B.side===an?Xt(n.CULL_FACE):wt(n.CULL_FACE);let it=B.side===li;rt&&(it=!it),vn(it),B.blending===Ko&&B.transparent===!1?rn(Yr):rn(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Et=B.stencilWrite;a.setTest(Et),Et&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Se(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?wt(n.SAMPLE_ALPHA_TO_COVERAGE):Xt(n.SAMPLE_ALPHA_TO_COVERAGE)}function vn(B){L!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),L=B)}function ze(B){B!==Sg?(wt(n.CULL_FACE),B!==F&&(B===Ud?n.cullFace(n.BACK):B===wg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xt(n.CULL_FACE),F=B}function Un(B){B!==G&&(V&&n.lineWidth(B),G=B)}function Se(B,rt,it){B?(wt(n.POLYGON_OFFSET_FILL),(N!==rt||z!==it)&&(N=rt,z=it,o.getReversed()&&(rt=-rt,it=-it),n.polygonOffset(rt,it))):Xt(n.POLYGON_OFFSET_FILL)}function Cn(B){B?wt(n.SCISSOR_TEST):Xt(n.SCISSOR_TEST)}function dn(B){B===void 0&&(B=n.TEXTURE0+Y-1),K!==B&&(n.activeTexture(B),K=B)}function bn(B,rt,it){it===void 0&&(K===null?it=n.TEXTURE0+Y-1:it=K);let Et=et[it];Et===void 0&&(Et={type:void 0,texture:void 0},et[it]=Et),(Et.type!==B||Et.texture!==rt)&&(K!==it&&(n.activeTexture(it),K=it),n.bindTexture(B,rt||Ct[B]),Et.type=B,Et.texture=rt)}function k(){let B=et[K];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function jt(){try{n.compressedTexImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function le(){try{n.texSubImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Mt(){try{n.texSubImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function He(){try{n.compressedTexSubImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Gt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function qt(){try{n.texStorage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function I(){try{n.texStorage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function w(){try{n.texImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function dt(B){return d[B]!==void 0?d[B]:n.getParameter(B)}function at(B,rt){d[B]!==rt&&(n.pixelStorei(B,rt),d[B]=rt)}function xt(B){Q.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function vt(B){gt.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),gt.copy(B))}function nt(B,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let Et=it.get(B);Et===void 0&&(Et=n.getUniformBlockIndex(rt,B.name),n.uniformBlockBinding(rt,Et,Et),it.set(B,Et))}function st(B,rt,it){let _t=c.get(rt).get(B);l[_t]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,it),l[_t]=it)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},K=null,et={},h={},l={},f=new WeakMap,p=[],g=null,m=!1,_=null,x=null,S=null,y=null,C=null,A=null,v=null,M=new Zt(0,0,0),U=0,P=!1,L=null,F=null,G=null,N=null,z=null,Q.set(0,0,n.canvas.width,n.canvas.height),gt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:Xt,bindFramebuffer:ae,drawBuffers:Vt,useProgram:me,setBlending:rn,setMaterial:Ye,setFlipSided:vn,setCullFace:ze,setLineWidth:Un,setPolygonOffset:Se,setScissorTest:Cn,activeTexture:dn,bindTexture:bn,unbindTexture:k,compressedTexImage2D:Pt,compressedTexImage3D:jt,texImage2D:w,texImage3D:q,pixelStorei:at,getParameter:dt,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:qt,texStorage3D:I,texSubImage2D:le,texSubImage3D:Mt,compressedTexSubImage2D:He,compressedTexSubImage3D:Gt,scissor:xt,viewport:vt,reset:pt}}function XA(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Wt,u=new WeakMap,d=new Set,h,f=new WeakMap,p=new Set,g=new FinalizationRegistry(I=>p.delete(I)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(I,w){return m?new OffscreenCanvas(I,w):Wa("canvas")}function x(I,w,q){let dt=1,at=qt(I);if((at.width>q||at.height>q)&&(dt=q/Math.max(at.width,at.height)),dt<1)if(typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&I instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&I instanceof ImageBitmap||typeof VideoFrame<"u"&&I instanceof VideoFrame){let xt=Math.floor(dt*at.width),vt=Math.floor(dt*at.height);h===void 0&&(h=_(xt,vt));let nt=w?_(xt,vt):h;return nt.width=xt,nt.height=vt,nt.getContext("2d").drawImage(I,0,0,xt,vt),Yt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+xt+"x"+vt+")."),nt}else return"data"in I&&Yt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),I;return I}function S(I){return I.generateMipmaps}function y(I){n.generateMipmap(I)}function C(I){return I.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:I.isWebGL3DRenderTarget?n.TEXTURE_3D:I.isWebGLArrayRenderTarget||I.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(I,w,q,dt,at,xt=!1){if(I!==null){if(n[I]!==void 0)return n[I];Yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+I+"'")}let vt;dt&&(vt=t.get("EXT_texture_norm16"),vt||Yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=w;if(w===n.RED&&(q===n.FLOAT&&(nt=n.R32F),q===n.HALF_FLOAT&&(nt=n.R16F),q===n.UNSIGNED_BYTE&&(nt=n.R8),q===n.UNSIGNED_SHORT&&vt&&(nt=vt.R16_EXT),q===n.SHORT&&vt&&(nt=vt.R16_SNORM_EXT)),w===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.R8UI),q===n.UNSIGNED_SHORT&&(nt=n.R16UI),q===n.UNSIGNED_INT&&(nt=n.R32UI),q===n.BYTE&&(nt=n.R8I),q===n.SHORT&&(nt=n.R16I),q===n.INT&&(nt=n.R32I)),w===n.RG&&(q===n.FLOAT&&(nt=n.RG32F),q===n.HALF_FLOAT&&(nt=n.RG16F),q===n.UNSIGNED_BYTE&&(nt=n.RG8),q===n.UNSIGNED_SHORT&&vt&&(nt=vt.RG16_EXT),q===n.SHORT&&vt&&(nt=vt.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.RG8UI),q===n.UNSIGNED_SHORT&&(nt=n.RG16UI),q===n.UNSIGNED_INT&&(nt=n.RG32UI),q===n.BYTE&&(nt=n.RG8I),q===n.SHORT&&(nt=n.RG16I),q===n.INT&&(nt=n.RG32I)),w===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),q===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),q===n.UNSIGNED_INT&&(nt=n.RGB32UI),q===n.BYTE&&(nt=n.RGB8I),q===n.SHORT&&(nt=n.RGB16I),q===n.INT&&(nt=n.RGB32I)),w===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),q===n.UNSIGNED_INT&&(nt=n.RGBA32UI),q===n.BYTE&&(nt=n.RGBA8I),q===n.SHORT&&(nt=n.RGBA16I),q===n.INT&&(nt=n.RGBA32I)),w===n.RGB&&(q===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGB16_EXT),q===n.SHORT&&vt&&(nt=vt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),w===n.RGBA){let st=xt?Ha:ve.getTransfer(at);q===n.FLOAT&&(nt=n.RGBA32F),q===n.HALF_FLOAT&&(nt=n.RGBA16F),q===n.UNSIGNED_BYTE&&(nt=st===Pe?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGBA16_EXT),q===n.SHORT&&vt&&(nt=vt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function v(I,w){let q;return I?w===null||w===Ki||w===Jr?q=n.DEPTH24_STENCIL8:w===Gi?q=n.DEPTH32F_STENCIL8:w===ta&&(q=n.DEPTH24_STENCIL8,Yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Ki||w===Jr?q=n.DEPTH_COMPONENT24:w===Gi?q=n.DEPTH_COMPONENT32F:w===ta&&(q=n.DEPTH_COMPONENT16),q}function M(I,w){return S(I)===!0||I.isFramebufferTexture&&I.minFilter!==Vn&&I.minFilter!==ri?Math.log2(Math.max(w.width,w.height))+1:I.mipmaps.length>0?I.mipmaps.length:I.isCompressedTexture&&Array.isArray(I.image)?w.mipmaps.length:1}function U(I){let w=new WeakRef(I);i.get(I).__ref=w,p.add(w),g.register(I,w,w)}function P(I){let w=i.get(I).__ref;w!==void 0&&(p.delete(w),g.unregister(w))}function L(I){G(I.target)}function F(I){N(I.target)}function G(I){I.removeEventListener("dispose",L),P(I),Y(I),I.isVideoTexture&&u.delete(I),I.isHTMLTexture&&d.delete(I)}function N(I){I.removeEventListener("dispose",F),P(I),ot(I)}function z(){for(let I of p){let w=I.deref();w!==void 0&&(w.isRenderTarget===!0?N(w):G(w))}p.clear(),d.clear()}function Y(I){let w=i.get(I);if(w.__webglInit===void 0)return;let q=I.source,dt=f.get(q);if(dt){let at=dt[w.__cacheKey];at.usedTimes--,at.usedTimes===0&&V(I),Object.keys(dt).length===0&&f.delete(q)}i.remove(I)}function V(I){let w=i.get(I);n.deleteTexture(w.__webglTexture);let q=I.source,dt=f.get(q);delete dt[w.__cacheKey],o.memory.textures--}function ot(I){let w=i.get(I);w.__depthDisposeCallback&&w.__depthDisposeCallback();let q=I.depthTexture;if(q&&q.renderTarget===I&&G(q),I.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(w.__webglFramebuffer[at]))for(let xt=0;xt<w.__webglFramebuffer[at].length;xt++)n.deleteFramebuffer(w.__webglFramebuffer[at][xt]);else n.deleteFramebuffer(w.__webglFramebuffer[at]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[at])}else{if(Array.isArray(w.__webglFramebuffer))for(let at=0;at<w.__webglFramebuffer.length;at++)n.deleteFramebuffer(w.__webglFramebuffer[at]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let at=0;at<w.__webglColorRenderbuffer.length;at++)w.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[at]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let dt=I.textures;for(let at=0,xt=dt.length;at<xt;at++){let vt=i.get(dt[at]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(dt[at])}i.remove(I)}let $=0;function K(){$=0}function et(){return $}function ht(I){$=I}function ut(){let I=$;return I>=s.maxTextures&&Yt("WebGLTextures: Trying to use "+(I+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,I}function Q(I){let w=[];return w.push(I.wrapS),w.push(I.wrapT),w.push(I.wrapR||0),w.push(I.magFilter),w.push(I.minFilter),w.push(I.anisotropy),w.push(I.internalFormat),w.push(I.format),w.push(I.type),w.push(I.generateMipmaps),w.push(I.mipmapsAutoUpdate),w.push(I.premultiplyAlpha),w.push(I.flipY),w.push(I.unpackAlignment),w.push(I.colorSpace),w.join()}function gt(I,w){let q=i.get(I);if(I.isVideoTexture&&He(I),I.isRenderTargetTexture===!1&&I.isExternalTexture!==!0&&I.version>0&&q.__version!==I.version){let dt=I.image;if(dt===null)Yt("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)Yt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ye(q,I,w);return}}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+w)}function yt(I,w){let q=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Ye(q,I,w);return}else I.isExternalTexture&&(q.__webglTexture=I.sourceTexture?I.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+w)}function Ct(I,w){let q=i.get(I);if(I.isRenderTargetTexture===!1&&I.version>0&&q.__version!==I.version){Ye(q,I,w);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+w)}function wt(I,w){let q=i.get(I);if(I.version>0&&q.__version!==I.version){vn(q,I,w);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+w)}let Xt={[Dc]:n.REPEAT,[fs]:n.CLAMP_TO_EDGE,[Nc]:n.MIRRORED_REPEAT},ae={[Vn]:n.NEAREST,[Xg]:n.NEAREST_MIPMAP_NEAREST,[hl]:n.NEAREST_MIPMAP_LINEAR,[ri]:n.LINEAR,[lh]:n.LINEAR_MIPMAP_NEAREST,[$s]:n.LINEAR_MIPMAP_LINEAR},Vt={[Zg]:n.NEVER,[af]:n.ALWAYS,[jg]:n.LESS,[rf]:n.LEQUAL,[Jg]:n.EQUAL,[of]:n.GEQUAL,[Kg]:n.GREATER,[Qg]:n.NOTEQUAL};function me(I,w){if(w.type===Gi&&t.has("OES_texture_float_linear")===!1&&(w.magFilter===ri||w.magFilter===lh||w.magFilter===hl||w.magFilter===$s||w.minFilter===ri||w.minFilter===lh||w.minFilter===hl||w.minFilter===$s)&&Yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(I,n.TEXTURE_WRAP_S,Xt[w.wrapS]),n.texParameteri(I,n.TEXTURE_WRAP_T,Xt[w.wrapT]),(I===n.TEXTURE_3D||I===n.TEXTURE_2D_ARRAY)&&n.texParameteri(I,n.TEXTURE_WRAP_R,Xt[w.wrapR]),n.texParameteri(I,n.TEXTURE_MAG_FILTER,ae[w.magFilter]),n.texParameteri(I,n.TEXTURE_MIN_FILTER,ae[w.minFilter]),w.compareFunction&&(n.texParameteri(I,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(I,n.TEXTURE_COMPARE_FUNC,Vt[w.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===Vn||w.minFilter!==hl&&w.minFilter!==$s||w.type===Gi&&t.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(I,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,s.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function de(I,w){let q=!1;I.__webglInit===void 0&&(I.__webglInit=!0,w.addEventListener("dispose",L),U(w));let dt=w.source,at=f.get(dt);at===void 0&&(at={},f.set(dt,at));let xt=Q(w);if(xt!==I.__cacheKey){at[xt]===void 0&&(at[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[xt].usedTimes++;let vt=at[I.__cacheKey];vt!==void 0&&(at[I.__cacheKey].usedTimes--,vt.usedTimes===0&&V(w)),I.__cacheKey=xt,I.__webglTexture=at[xt].texture}return q}function re(I,w,q){return Math.floor(Math.floor(I/q)/w)}function rn(I,w,q,dt){let xt=I.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,q,dt,w.data);else{xt.sort((B,rt)=>B.start-rt.start);let vt=0;for(let B=1;B<xt.length;B++){let rt=xt[vt],it=xt[B],Et=rt.start+rt.count,_t=re(it.start,w.width,4),St=re(rt.start,w.width,4);it.start<=Et+1&&_t===St&&re(it.start+it.count-1,w.width,4)===_t?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++vt,xt[vt]=it)}xt.length=vt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let B=0,rt=xt.length;B<rt;B++){let it=xt[B],Et=Math.floor(it.start/4),_t=Math.ceil(it.count/4),St=Et%w.width,Ht=Math.floor(Et/w.width),Qt=_t,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,St),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,St,Ht,Qt,ct,q,dt,w.data)}I.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function Ye(I,w,q){let dt=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(dt=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(dt=n.TEXTURE_3D);let at=de(I,w),xt=w.source;e.bindTexture(dt,I.__webglTexture,n.TEXTURE0+q);let vt=i.get(xt);if(xt.version!==vt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ct=ve.getPrimaries(ve.workingColorSpace),Bt=w.colorSpace===Ys?null:ve.getPrimaries(w.colorSpace),te=w.colorSpace===Ys||ct===Bt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let st=x(w.image,!1,s.maxTextureSize);st=Gt(w,st);let pt=r.convert(w.format,w.colorSpace),B=r.convert(w.type),rt=A(w.internalFormat,pt,B,w.normalized,w.colorSpace,w.isVideoTexture);me(dt,w);let it,Et=w.mipmaps,_t=w.isVideoTexture!==!0,St=vt.__version===void 0||at===!0,Ht=xt.dataReady,Qt=M(w,st);if(w.isDepthTexture)rt=v(w.format===qs,w.type),St&&(_t?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,pt,B,null));else if(w.isDataTexture)if(Et.length>0){_t&&St&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ct=0,Bt=Et.length;ct<Bt;ct++)it=Et[ct],_t?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,B,it.data):e.texImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,pt,B,it.data);w.generateMipmaps=!1}else _t?(St&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,st.width,st.height),Ht&&rn(w,st,pt,B)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,pt,B,st.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){_t&&St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,rt,Et[0].width,Et[0].height,st.depth);for(let ct=0,Bt=Et.length;ct<Bt;ct++)if(it=Et[ct],w.format!==ts)if(pt!==null)if(_t){if(Ht)if(w.layerUpdates.size>0){let te=xf(it.width,it.height,w.format,w.type);for(let Rt of w.layerUpdates){let ue=it.data.subarray(Rt*te/it.data.BYTES_PER_ELEMENT,(Rt+1)*te/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Rt,it.width,it.height,1,pt,ue)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,pt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,it.width,it.height,st.depth,0,it.data,0,0);else Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,pt,B,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,it.width,it.height,st.depth,0,pt,B,it.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{_t&&St&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ct=0,Bt=Et.length;ct<Bt;ct++)it=Et[ct],w.format!==ts?pt!==null?_t?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,it.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,B,it.data):e.texImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,pt,B,it.data)}else if(w.isDataArrayTexture)if(_t){if(St&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,rt,st.width,st.height,st.depth),Ht)if(w.layerUpdates.size>0){let ct=xf(st.width,st.height,w.format,w.type);for(let Bt of w.layerUpdates){let te=st.data.subarray(Bt*ct/st.data.BYTES_PER_ELEMENT,(Bt+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Bt,st.width,st.height,1,pt,B,te)}w.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,pt,B,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,pt,B,st.data);else if(w.isData3DTexture)_t?(St&&e.texStorage3D(n.TEXTURE_3D,Qt,rt,st.width,st.height,st.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,pt,B,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,pt,B,st.data);else if(w.isFramebufferTexture){if(St)if(_t)e.texStorage2D(n.TEXTURE_2D,Qt,rt,st.width,st.height);else{let ct=st.width,Bt=st.height;for(let te=0;te<Qt;te++)e.texImage2D(n.TEXTURE_2D,te,rt,ct,Bt,0,pt,B,null),ct>>=1,Bt>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),d.add(w),ct.onpaint=Bt=>{let te=Bt.changedElements;for(let Rt of d)te.includes(Rt.image)&&(Rt.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let te=n.RGBA,Rt=n.RGBA,ue=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,te,Rt,ue,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&St){let ct=qt(Et[0]);e.texStorage2D(n.TEXTURE_2D,Qt,rt,ct.width,ct.height)}for(let ct=0,Bt=Et.length;ct<Bt;ct++)it=Et[ct],_t?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,pt,B,it):e.texImage2D(n.TEXTURE_2D,ct,rt,pt,B,it);w.generateMipmaps=!1}else if(_t){if(St){let ct=qt(st);e.texStorage2D(n.TEXTURE_2D,Qt,rt,ct.width,ct.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,B,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,pt,B,st);S(w)&&w.mipmapsAutoUpdate===!0&&y(dt),vt.__version=xt.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function vn(I,w,q){if(w.image.length!==6)return;let dt=de(I,w),at=w.source;e.bindTexture(n.TEXTURE_CUBE_MAP,I.__webglTexture,n.TEXTURE0+q);let xt=i.get(at);if(at.version!==xt.__version||dt===!0){e.activeTexture(n.TEXTURE0+q);let vt=ve.getPrimaries(ve.workingColorSpace),nt=w.colorSpace===Ys?null:ve.getPrimaries(w.colorSpace),st=w.colorSpace===Ys||vt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let pt=w.isCompressedTexture||w.image[0].isCompressedTexture,B=w.image[0]&&w.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!pt&&!B?rt[Rt]=x(w.image[Rt],!0,s.maxCubemapSize):rt[Rt]=B?w.image[Rt].image:w.image[Rt],rt[Rt]=Gt(w,rt[Rt]);let it=rt[0],Et=r.convert(w.format,w.colorSpace),_t=r.convert(w.type),St=A(w.internalFormat,Et,_t,w.normalized,w.colorSpace),Ht=w.isVideoTexture!==!0,Qt=xt.__version===void 0||dt===!0,ct=at.dataReady,Bt=M(w,it);me(n.TEXTURE_CUBE_MAP,w);let te;if(w.isDepthTexture){if(St=v(w.format===qs,w.type),Qt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,St,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,it.width,it.height,0,Et,_t,null)}else if(pt){Ht&&Qt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,St,it.width,it.height);for(let Rt=0;Rt<6;Rt++){te=rt[Rt].mipmaps;for(let ue=0;ue<te.length;ue++){let Je=te[ue];w.format!==ts?Et!==null?Ht?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,Je.width,Je.height,Et,Je.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,St,Je.width,Je.height,0,Je.data):Yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,0,0,Je.width,Je.height,Et,_t,Je.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue,St,Je.width,Je.height,0,Et,_t,Je.data)}}}else{if(te=w.mipmaps,Ht&&Qt){te.length>0&&Bt++;let Rt=qt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,St,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(B){Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,Et,_t,rt[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,rt[Rt].width,rt[Rt].height,0,Et,_t,rt[Rt].data);for(let ue=0;ue<te.length;ue++){let Qn=te[ue].image[Rt].image;Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Qn.width,Qn.height,Et,_t,Qn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,St,Qn.width,Qn.height,0,Et,_t,Qn.data)}}else{Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Et,_t,rt[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,St,Et,_t,rt[Rt]);for(let ue=0;ue<te.length;ue++){let Je=te[ue];Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,0,0,Et,_t,Je.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,ue+1,St,Et,_t,Je.image[Rt])}}}S(w)&&w.mipmapsAutoUpdate===!0&&y(n.TEXTURE_CUBE_MAP),xt.__version=at.version,w.onUpdate&&w.onUpdate(w)}I.__version=w.version}function ze(I,w,q,dt,at,xt){let vt=r.convert(q.format,q.colorSpace),nt=r.convert(q.type),st=A(q.internalFormat,vt,nt,q.normalized,q.colorSpace),pt=i.get(w),B=i.get(q);if(B.__renderTarget=w,!pt.__hasExternalTextures){let rt=Math.max(1,w.width>>xt),it=Math.max(1,w.height>>xt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,xt,st,rt,it,w.depth,0,vt,nt,null):e.texImage2D(at,xt,st,rt,it,0,vt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,I),Mt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,dt,at,B.__webglTexture,0,le(w)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,dt,at,B.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Un(I,w,q){if(n.bindRenderbuffer(n.RENDERBUFFER,I),w.depthBuffer){let dt=w.depthTexture,at=dt&&dt.isDepthTexture?dt.type:null,xt=v(w.stencilBuffer,at),vt=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Mt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(w),xt,w.width,w.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(w),xt,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,xt,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,I)}else{let dt=w.textures;for(let at=0;at<dt.length;at++){let xt=dt[at],vt=r.convert(xt.format,xt.colorSpace),nt=r.convert(xt.type),st=A(xt.internalFormat,vt,nt,xt.normalized,xt.colorSpace);Mt(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(w),st,w.width,w.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(w),st,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,st,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Se(I,w,q){let dt=w.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,I),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(w.depthTexture);at.__renderTarget=w;let xt=dt?w.depthTexture.image[0]:w.depthTexture.image;(!at.__webglTexture||xt.width!==w.width||xt.height!==w.height)&&(xt.width=w.width,xt.height=w.height,w.depthTexture.needsUpdate=!0),dt?wt(w.depthTexture,0):gt(w.depthTexture,0);let vt=at.__webglTexture,nt=le(w),st=dt?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pt=w.depthTexture.format===qs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===zs)Mt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,st,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,pt,st,vt,0);else if(w.depthTexture.format===qs)Mt(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,st,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,pt,st,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Cn(I){let w=i.get(I),q=I.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==I.depthTexture){let dt=I.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),dt){let at=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,dt.removeEventListener("dispose",at)};dt.addEventListener("dispose",at),w.__depthDisposeCallback=at}w.__boundDepthTexture=dt}if(I.depthTexture&&!w.__autoAllocateDepthBuffer)if(q)for(let dt=0;dt<6;dt++)Se(w.__webglFramebuffer[dt],I,dt);else I.texture.mipmaps.length>0?Se(w.__webglFramebuffer[0],I,0):Se(w.__webglFramebuffer,I,0);else if(q){w.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[dt]),w.__webglDepthbuffer[dt]===void 0)w.__webglDepthbuffer[dt]=n.createRenderbuffer(),Un(w.__webglDepthbuffer[dt],I,!1);else{let at=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=w.__webglDepthbuffer[dt];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}}else if(I.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Un(w.__webglDepthbuffer,I,!1);else{let at=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(I,w,q){let dt=i.get(I);w!==void 0&&ze(dt.__webglFramebuffer,I,I.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Cn(I)}function bn(I){let w=I.texture,q=i.get(I),dt=i.get(w);I.addEventListener("dispose",F),U(I);let at=I.textures,xt=I.isWebGLCubeRenderTarget===!0,vt=at.length>1;if(vt||(dt.__webglTexture===void 0&&(dt.__webglTexture=n.createTexture()),dt.__version=w.version,o.memory.textures++),xt){q.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0){q.__webglFramebuffer[nt]=[];for(let st=0;st<w.mipmaps.length;st++)q.__webglFramebuffer[nt][st]=n.createFramebuffer()}else q.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(w.mipmaps.length>0){q.__webglFramebuffer=[];for(let nt=0;nt<w.mipmaps.length;nt++)q.__webglFramebuffer[nt]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(vt)for(let nt=0,st=at.length;nt<st;nt++){let pt=i.get(at[nt]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(I.samples>0&&Mt(I)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];q.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[nt]);let pt=r.convert(st.format,st.colorSpace),B=r.convert(st.type),rt=A(st.internalFormat,pt,B,st.normalized,st.colorSpace,I.isXRRenderTarget===!0),it=le(I);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,rt,I.width,I.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,q.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),I.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Un(q.__webglDepthRenderbuffer,I,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,dt.__webglTexture),me(n.TEXTURE_CUBE_MAP,w);for(let nt=0;nt<6;nt++)if(w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)ze(q.__webglFramebuffer[nt][st],I,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else ze(q.__webglFramebuffer[nt],I,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);S(w)?y(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let nt=0,st=at.length;nt<st;nt++){let pt=at[nt],B=i.get(pt),rt=n.TEXTURE_2D;(I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(rt=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,B.__webglTexture),me(rt,pt),ze(q.__webglFramebuffer,I,pt,n.COLOR_ATTACHMENT0+nt,rt,0),S(pt)&&y(rt)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((I.isWebGL3DRenderTarget||I.isWebGLArrayRenderTarget)&&(nt=I.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,dt.__webglTexture),me(nt,w),w.mipmaps.length>0)for(let st=0;st<w.mipmaps.length;st++)ze(q.__webglFramebuffer[st],I,w,n.COLOR_ATTACHMENT0,nt,st);else ze(q.__webglFramebuffer,I,w,n.COLOR_ATTACHMENT0,nt,0);S(w)?y(nt):w.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),e.unbindTexture()}I.depthBuffer&&Cn(I)}function k(I){let w=I.textures;for(let q=0,dt=w.length;q<dt;q++){let at=w[q];if(S(at)&&at.mipmapsAutoUpdate===!0){let xt=C(I),vt=i.get(at).__webglTexture;e.bindTexture(xt,vt),y(xt),e.unbindTexture()}}}let Pt=[];function jt(I){if(I.samples>0){if(Mt(I)===!1){let w=I.textures,q=I.width,dt=I.height,at=n.COLOR_BUFFER_BIT,xt=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(I),nt=w.length>1;if(nt)for(let pt=0;pt<w.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),I.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let pt=0;pt<w.length;pt++){if(I.resolveDepthBuffer&&(I.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),I.stencilBuffer&&I.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let B=i.get(w[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,dt,0,0,q,dt,at,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+pt),I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&Pt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let pt=0;pt<w.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let B=i.get(w[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(I.depthBuffer&&I.storeMultisampledDepthBuffer===!1&&l){let w=I.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function le(I){return Math.min(s.maxSamples,I.samples)}function Mt(I){let w=i.get(I);return I.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function He(I){let w=o.render.frame;u.get(I)!==w&&(u.set(I,w),I.update())}function Gt(I,w){let q=I.colorSpace,dt=I.format,at=I.type;return I.isCompressedTexture===!0||I.isVideoTexture===!0||q!==Va&&q!==Ys&&(ve.getTransfer(q)===Pe?(dt!==ts||at!==fi)&&Yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ee("WebGLTextures: Unsupported texture color space:",q)),w}function qt(I){return typeof HTMLImageElement<"u"&&I instanceof HTMLImageElement?(c.width=I.naturalWidth||I.width,c.height=I.naturalHeight||I.height):typeof VideoFrame<"u"&&I instanceof VideoFrame?(c.width=I.displayWidth,c.height=I.displayHeight):(c.width=I.width,c.height=I.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=K,this.getTextureUnits=et,this.setTextureUnits=ht,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Ct,this.setTextureCube=wt,this.rebindTextures=dn,this.setupRenderTarget=bn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=Cn,this.setupFrameBufferTexture=ze,this.useMultisampledRTT=Mt,this.dispose=z}function $A(n,t){function e(i,s=Ys){let r,o=ve.getTransfer(s);if(i===fi)return n.UNSIGNED_BYTE;if(i===hh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===uh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Kd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Qd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===jd)return n.BYTE;if(i===Jd)return n.SHORT;if(i===ta)return n.UNSIGNED_SHORT;if(i===ch)return n.INT;if(i===Ki)return n.UNSIGNED_INT;if(i===Gi)return n.FLOAT;if(i===Qi)return n.HALF_FLOAT;if(i===tf)return n.ALPHA;if(i===ef)return n.RGB;if(i===ts)return n.RGBA;if(i===zs)return n.DEPTH_COMPONENT;if(i===qs)return n.DEPTH_STENCIL;if(i===dh)return n.RED;if(i===fh)return n.RED_INTEGER;if(i===wr)return n.RG;if(i===ph)return n.RG_INTEGER;if(i===mh)return n.RGBA_INTEGER;if(i===ul||i===dl||i===fl||i===pl)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ul)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ul)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===gh||i===_h||i===xh||i===yh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===gh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===_h)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===xh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===yh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===vh||i===bh||i===Sh||i===wh||i===Mh||i===ml||i===Eh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===vh||i===bh)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Sh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===wh)return r.COMPRESSED_R11_EAC;if(i===Mh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ml)return r.COMPRESSED_RG11_EAC;if(i===Eh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ah||i===Th||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Oh||i===Uh||i===Fh||i===Bh||i===kh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ah)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Th)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ch)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Rh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ph)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ih)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Lh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Dh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Nh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Oh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Uh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Fh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Bh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===kh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===zh||i===Gh||i===Vh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===zh)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Gh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Vh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Hh||i===Wh||i===gl||i===Xh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Hh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Wh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===gl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Xh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Jr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var qA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,YA=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Lf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Qa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new zi({vertexShader:qA,fragmentShader:YA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new mt(new Wr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Df=class extends Ji{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,p=null,g=typeof XRWebGLBinding<"u",m=new Lf,_={},x=e.getContextAttributes(),S=null,y=null,C=[],A=[],v=new Wt,M=null,U=null,P=new wi;P.viewport=new Le;let L=new wi;L.viewport=new Le;let F=[P,L],G=new ih,N=null,z=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let gt=C[Q];return gt===void 0&&(gt=new $o,C[Q]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(Q){let gt=C[Q];return gt===void 0&&(gt=new $o,C[Q]=gt),gt.getGripSpace()},this.getHand=function(Q){let gt=C[Q];return gt===void 0&&(gt=new $o,C[Q]=gt),gt.getHandSpace()};function Y(Q){let gt=A.indexOf(Q.inputSource);if(gt===-1)return;let yt=C[gt];yt!==void 0&&(yt.update(Q.inputSource,Q.frame,c||o),yt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function V(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ot);for(let Q=0;Q<C.length;Q++){let gt=A[Q];gt!==null&&(A[Q]=null,C[Q].disconnect(gt))}N=null,z=null,m.reset();for(let Q in _)delete _[Q];if(t.setRenderTarget(S),f=null,h=null,d=null,s=null,y=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(v.width,v.height,!1),U!==null){let Q=U.camera;Q.fov=U.fov,Q.zoom=U.zoom,Q.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&g&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ot),x.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(v),g&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Ct=null,wt=null;x.depth&&(wt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=x.stencil?qs:zs,Ct=x.stencil?Jr:Ki);let Xt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Xt),s.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),y=new Mi(h.textureWidth,h.textureHeight,{format:ts,type:fi,depthTexture:new Hs(h.textureWidth,h.textureHeight,Ct,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let yt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),y=new Mi(f.framebufferWidth,f.framebufferHeight,{format:ts,type:fi,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}y.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ot(Q){for(let gt=0;gt<Q.removed.length;gt++){let yt=Q.removed[gt],Ct=A.indexOf(yt);Ct>=0&&(A[Ct]=null,C[Ct].disconnect(yt))}for(let gt=0;gt<Q.added.length;gt++){let yt=Q.added[gt],Ct=A.indexOf(yt);if(Ct===-1){for(let Xt=0;Xt<C.length;Xt++)if(Xt>=A.length){A.push(yt),Ct=Xt;break}else if(A[Xt]===null){A[Xt]=yt,Ct=Xt;break}if(Ct===-1)break}let wt=C[Ct];wt&&wt.connect(yt)}}function $(Q,gt){gt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(gt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let gt=Q.near,yt=Q.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(yt=m.depthFar)),G.near=L.near=P.near=gt,G.far=L.far=P.far=yt,(N!==G.near||z!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),N=G.near,z=G.far),G.layers.mask=Q.layers.mask|6,P.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Ct=Q.parent,wt=G.cameras;$(G,Ct);for(let Xt=0;Xt<wt.length;Xt++)$(wt[Xt],Ct);G.projectionMatrix.copy(P.projectionMatrix),G.projectionMatrixInverse.copy(P.projectionMatrixInverse),U===null&&Q.isPerspectiveCamera&&(U={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,G,Ct)};function K(Q,gt,yt){yt===null?Q.matrix.copy(gt.matrixWorld):(Q.matrix.copy(yt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(gt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(gt.projectionMatrix),Q.projectionMatrixInverse.copy(gt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Ho*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(Q){return _[Q]};let et=null;function ht(Q,gt){if(u=gt.getViewerPose(c||o),p=gt,u!==null){let yt=u.views;f!==null&&(t.setRenderTargetFramebuffer(y,f.framebuffer),t.setRenderTarget(y));let Ct=!1;yt.length!==G.cameras.length&&(G.cameras.length=0,Ct=!0);for(let Vt=0;Vt<yt.length;Vt++){let me=yt[Vt],de=null;if(f!==null)de=f.getViewport(me);else{let rn=d.getViewSubImage(h,me);de=rn.viewport,Vt===0&&(t.setRenderTargetTextures(y,rn.colorTexture,rn.depthStencilTexture),t.setRenderTarget(y))}let re=F[Vt];re===void 0&&(re=new wi,re.layers.enable(Vt),re.viewport=new Le,F[Vt]=re),re.matrix.fromArray(me.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(me.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(de.x,de.y,de.width,de.height),Vt===0&&(G.matrix.copy(re.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ct===!0&&G.cameras.push(re)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&g){d=i.getBinding();let Vt=d.getDepthInformation(yt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(wt&&wt.includes("camera-access")&&g){t.state.unbindTexture(),d=i.getBinding();for(let Vt=0;Vt<yt.length;Vt++){let me=yt[Vt].camera;if(me){let de=_[me];de||(de=new Qa,_[me]=de);let re=d.getCameraImage(me);de.sourceTexture=re}}}}for(let yt=0;yt<C.length;yt++){let Ct=A[yt],wt=C[yt];Ct!==null&&wt!==void 0&&wt.update(Ct,gt,c||o)}et&&et(Q,gt),gt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:gt}),p=null}let ut=new C0;ut.setAnimationLoop(ht),this.setAnimationLoop=function(Q){et=Q},this.dispose=function(){}}},ZA=new Kt,B0=new se;B0.set(-1,0,0,0,1,0,0,0,1);function jA(n,t){function e(m,_){m.matrixAutoUpdate===!0&&m.updateMatrix(),_.value.copy(m.matrix)}function i(m,_){_.color.getRGB(m.fogColor.value,mf(n)),_.isFog?(m.fogNear.value=_.near,m.fogFar.value=_.far):_.isFogExp2&&(m.fogDensity.value=_.density)}function s(m,_,x,S,y){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(m,_):_.isMeshLambertMaterial?(r(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(m,_),d(m,_)):_.isMeshPhongMaterial?(r(m,_),u(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(m,_),h(m,_),_.isMeshPhysicalMaterial&&f(m,_,y)):_.isMeshMatcapMaterial?(r(m,_),p(m,_)):_.isMeshDepthMaterial?r(m,_):_.isMeshDistanceMaterial?(r(m,_),g(m,_)):_.isMeshNormalMaterial?r(m,_):_.isLineBasicMaterial?(o(m,_),_.isLineDashedMaterial&&a(m,_)):_.isPointsMaterial?l(m,_,x,S):_.isSpriteMaterial?c(m,_):_.isShadowMaterial?(m.color.value.copy(_.color),m.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(m,_){m.opacity.value=_.opacity,_.color&&m.diffuse.value.copy(_.color),_.emissive&&m.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(m.map.value=_.map,e(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,e(_.alphaMap,m.alphaMapTransform)),_.bumpMap&&(m.bumpMap.value=_.bumpMap,e(_.bumpMap,m.bumpMapTransform),m.bumpScale.value=_.bumpScale,_.side===li&&(m.bumpScale.value*=-1)),_.normalMap&&(m.normalMap.value=_.normalMap,e(_.normalMap,m.normalMapTransform),m.normalScale.value.copy(_.normalScale),_.side===li&&m.normalScale.value.negate()),_.displacementMap&&(m.displacementMap.value=_.displacementMap,e(_.displacementMap,m.displacementMapTransform),m.displacementScale.value=_.displacementScale,m.displacementBias.value=_.displacementBias),_.emissiveMap&&(m.emissiveMap.value=_.emissiveMap,e(_.emissiveMap,m.emissiveMapTransform)),_.specularMap&&(m.specularMap.value=_.specularMap,e(_.specularMap,m.specularMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest);let x=t.get(_),S=x.envMap,y=x.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(ZA.makeRotationFromEuler(y)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(B0),m.reflectivity.value=_.reflectivity,m.ior.value=_.ior,m.refractionRatio.value=_.refractionRatio),_.lightMap&&(m.lightMap.value=_.lightMap,m.lightMapIntensity.value=_.lightMapIntensity,e(_.lightMap,m.lightMapTransform)),_.aoMap&&(m.aoMap.value=_.aoMap,m.aoMapIntensity.value=_.aoMapIntensity,e(_.aoMap,m.aoMapTransform))}function o(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,_.map&&(m.map.value=_.map,e(_.map,m.mapTransform))}function a(m,_){m.dashSize.value=_.dashSize,m.totalSize.value=_.dashSize+_.gapSize,m.scale.value=_.scale}function l(m,_,x,S){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.size.value=_.size*x,m.scale.value=S*.5,_.map&&(m.map.value=_.map,e(_.map,m.uvTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,e(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function c(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.rotation.value=_.rotation,_.map&&(m.map.value=_.map,e(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,e(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function u(m,_){m.specular.value.copy(_.specular),m.shininess.value=Math.max(_.shininess,1e-4)}function d(m,_){_.gradientMap&&(m.gradientMap.value=_.gradientMap)}function h(m,_){m.metalness.value=_.metalness,_.metalnessMap&&(m.metalnessMap.value=_.metalnessMap,e(_.metalnessMap,m.metalnessMapTransform)),m.roughness.value=_.roughness,_.roughnessMap&&(m.roughnessMap.value=_.roughnessMap,e(_.roughnessMap,m.roughnessMapTransform)),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)}function f(m,_,x){m.ior.value=_.ior,_.diffuseRoughness>0&&(m.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=_.diffuseRoughnessMap,e(_.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),_.sheen>0&&(m.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),m.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(m.sheenColorMap.value=_.sheenColorMap,e(_.sheenColorMap,m.sheenColorMapTransform)),_.sheenRoughnessMap&&(m.sheenRoughnessMap.value=_.sheenRoughnessMap,e(_.sheenRoughnessMap,m.sheenRoughnessMapTransform))),_.clearcoat>0&&(m.clearcoat.value=_.clearcoat,m.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(m.clearcoatMap.value=_.clearcoatMap,e(_.clearcoatMap,m.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,e(_.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(m.clearcoatNormalMap.value=_.clearcoatNormalMap,e(_.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===li&&m.clearcoatNormalScale.value.negate())),_.dispersion>0&&(m.dispersion.value=_.dispersion),_.retroreflectivity>0&&(m.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(m.iridescence.value=_.iridescence,m.iridescenceIOR.value=_.iridescenceIOR,m.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(m.iridescenceMap.value=_.iridescenceMap,e(_.iridescenceMap,m.iridescenceMapTransform)),_.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=_.iridescenceThicknessMap,e(_.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),_.transmission>0&&(m.transmission.value=_.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),_.transmissionMap&&(m.transmissionMap.value=_.transmissionMap,e(_.transmissionMap,m.transmissionMapTransform)),m.thickness.value=_.thickness,_.thicknessMap&&(m.thicknessMap.value=_.thicknessMap,e(_.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=_.attenuationDistance,m.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(m.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(m.anisotropyMap.value=_.anisotropyMap,e(_.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=_.specularIntensity,m.specularColor.value.copy(_.specularColor),_.specularColorMap&&(m.specularColorMap.value=_.specularColorMap,e(_.specularColorMap,m.specularColorMapTransform)),_.specularIntensityMap&&(m.specularIntensityMap.value=_.specularIntensityMap,e(_.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,_){_.matcap&&(m.matcap.value=_.matcap)}function g(m,_){let x=t.get(_).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function JA(n,t,e,i){let s={},r={};function o(x,S){let y=S.program;i.uniformBlockBinding(x,y,s[x.id])}function a(x,S){let y=s[x.id];y===void 0&&(p(x),y=l(x),s[x.id]=y,x.addEventListener("dispose",m));let C=S.program;i.updateUBOMapping(x,C);let A=t.render.frame;r[x.id]!==A&&(c(x),r[x.id]=A)}function l(x){let S=n.createBuffer(),y=x.__size,C=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,y,C),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function c(x){let S=s[x.id],y=x.uniforms,C=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let A=0,v=y.length;A<v;A++){let M=y[A];if(Array.isArray(M))for(let U=0,P=M.length;U<P;U++)u(M[U],A,U,C);else u(M,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,S,y,C){if(h(x,S,y,C)===!0){let A=x.__offset,v=x.value;if(Array.isArray(v)){let M=0;for(let U=0;U<v.length;U++){let P=v[U],L=g(P,!0);d(P,x.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,x.__data)}}function d(x,S,y){typeof x=="number"||typeof x=="boolean"?S[y]=x:x.isMatrix3?(S[y]=x.elements[0],S[y+1]=x.elements[1],S[y+2]=x.elements[2],S[y+3]=0,S[y+4]=x.elements[3],S[y+5]=x.elements[4],S[y+6]=x.elements[5],S[y+7]=0,S[y+8]=x.elements[6],S[y+9]=x.elements[7],S[y+10]=x.elements[8],S[y+11]=0):ArrayBuffer.isView(x)?S.set(x.subarray(0,S.length-y),y):x.toArray(S,y)}function h(x,S,y,C){let A=x.value,v=S+"_"+y;if(Array.isArray(A)){C[v]===void 0&&(C[v]=[]);let M=C[v],U=!1;for(let P=0;P<A.length;P++)f(A[P],M,P)===!0&&(U=!0);return U}return f(A,C,v)}function f(x,S,y){if(S[y]===void 0)return typeof x=="number"||typeof x=="boolean"?S[y]=x:ArrayBuffer.isView(x)?S[y]=x.slice():S[y]=x.clone(),!0;{let C=S[y];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return S[y]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function p(x){let S=x.uniforms,y=0,C=16;for(let v=0,M=S.length;v<M;v++){let U=Array.isArray(S[v])?S[v]:[S[v]];for(let P=0,L=U.length;P<L;P++){let F=U[P],G=Array.isArray(F.value)?F.value:[F.value],N=Array.isArray(S[v])||Array.isArray(F.value),z=y;for(let V=0,ot=G.length;V<ot;V++){let $=G[V],K=g($,N),et=y%C,ht=et%K.boundary,ut=et+ht;y+=ht,ut!==0&&C-ut<K.storage&&(y+=C-ut),V===0&&(z=y),y+=K.storage}let Y=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new Y((y-z)/Float32Array.BYTES_PER_ELEMENT),F.__offset=z}}let A=y%C;return A>0&&(y+=C-A),x.__size=y,x.__cache={},this}function g(x,S){let y={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(y.boundary=4,y.storage=4):x.isVector2?(y.boundary=8,y.storage=8):x.isVector3||x.isColor?(y.boundary=16,y.storage=12):x.isVector4?(y.boundary=16,y.storage=16):x.isMatrix3?(y.boundary=16,y.storage=48):x.isMatrix4?(y.boundary=16,y.storage=64):x.isTexture?Yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(y.boundary=16,y.storage=x.byteLength):Yt("WebGLRenderer: Unsupported uniform value type.",x),S===!0&&(y.boundary=16,y.storage=Math.ceil(y.storage/16)*16),y}function m(x){let S=x.target;S.removeEventListener("dispose",m),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function _(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:_}}var KA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),gs=null;function QA(){return gs===null&&(gs=new ja(KA,16,16,wr,Qi),gs.name="DFG_LUT",gs.minFilter=ri,gs.magFilter=ri,gs.wrapS=fs,gs.wrapT=fs,gs.generateMipmaps=!1,gs.needsUpdate=!0),gs}var ia=class{constructor(t={}){let{canvas:e=t0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=fi}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let g=f,m=new Set([mh,ph,fh]),_=new Set([fi,Ki,ta,Jr,hh,uh]),x=new Uint32Array(4),S=new Int32Array(4),y={textures:[],min:[],max:[],resolution:[]},C=null,A=null,v=[],M=[],U=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ms,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,L=!1,F=null,G=null,N=null,z=null;this._outputColorSpace=bi;let Y=0,V=0,ot=null,$=-1,K=null,et=new Le,ht=new Le,ut=null,Q=new Zt(0),gt=0,yt=e.width,Ct=e.height,wt=1,Xt=null,ae=null,Vt=new Le(0,0,yt,Ct),me=new Le(0,0,yt,Ct),de=!1,re=new pr,rn=new kc,Ye=!1,vn=!1,ze=new Kt,Un=new R,Se=new Le,Cn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},dn=!1;function bn(){return ot===null?wt:1}let k=i;function Pt(T,H){return e.getContext(T,H)}let jt,le,Mt,He,Gt,qt,I,w,q,dt,at,xt,vt,nt,st,pt,B,rt,it,Et,_t,St,Ht;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),k===null){let H="webgl2";if(k=Pt(H,T),k===null)throw Pt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(T){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),ee("WebGLRenderer: "+T.message),T}function Qt(){jt=new hE(k),jt.init(),_t=new $A(k,jt),le=new Q1(k,jt,t,_t),Mt=new WA(k,jt),le.reversedDepthBuffer&&h&&Mt.buffers.depth.setReversed(!0),G=k.createFramebuffer(),N=k.createFramebuffer(),z=k.createFramebuffer(),He=new fE(k),Gt=new PA,qt=new XA(k,jt,Mt,Gt,le,_t,He),I=new cE(P),w=new mw(k),St=new J1(k,w),q=new uE(k,w,He,St),dt=new mE(k,q,w,St,He),rt=new pE(k,le,qt),st=new tE(Gt),at=new RA(P,I,jt,le,St,st),xt=new jA(P,Gt),vt=new LA,nt=new BA(jt),B=new j1(P,I,Mt,dt,p,l),pt=new HA(P,dt,le),Ht=new JA(k,He,le,Mt),it=new K1(k,jt,He),Et=new dE(k,jt,He),He.programs=at.programs,P.capabilities=le,P.extensions=jt,P.properties=Gt,P.renderLists=vt,P.shadowMap=pt,P.state=Mt,P.info=He}g!==fi&&(U=new _E(g,e.width,e.height,a,s,r));let ct=new Df(P,k);this.xr=ct,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=jt.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=jt.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(T){T!==void 0&&(wt=T,this.setSize(yt,Ct,!1))},this.getSize=function(T){return T.set(yt,Ct)},this.setSize=function(T,H,tt=!0){if(ct.isPresenting){Yt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=T,Ct=H,e.width=Math.floor(T*wt),e.height=Math.floor(H*wt),tt===!0&&(e.style.width=T+"px",e.style.height=H+"px"),U!==null&&U.setSize(e.width,e.height),this.setViewport(0,0,T,H)},this.getDrawingBufferSize=function(T){return T.set(yt*wt,Ct*wt).floor()},this.setDrawingBufferSize=function(T,H,tt){yt=T,Ct=H,wt=tt,e.width=Math.floor(T*tt),e.height=Math.floor(H*tt),this.setViewport(0,0,T,H)},this.setEffects=function(T){if(g===fi){ee("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let H=0;H<T.length;H++)if(T[H].isOutputPass===!0){Yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(et)},this.getViewport=function(T){return T.copy(Vt)},this.setViewport=function(T,H,tt,Z){T.isVector4?Vt.set(T.x,T.y,T.z,T.w):Vt.set(T,H,tt,Z),Mt.viewport(et.copy(Vt).multiplyScalar(bn()).round())},this.getScissor=function(T){return T.copy(me)},this.setScissor=function(T,H,tt,Z){T.isVector4?me.set(T.x,T.y,T.z,T.w):me.set(T,H,tt,Z),Mt.scissor(ht.copy(me).multiplyScalar(bn()).round())},this.getScissorTest=function(){return de},this.setScissorTest=function(T){Mt.setScissorTest(de=T)},this.setOpaqueSort=function(T){Xt=T},this.setTransparentSort=function(T){ae=T},this.getClearColor=function(T){return T.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(T=!0,H=!0,tt=!0){let Z=0;if(T){let j=!1;if(ot!==null){let At=ot.texture.format;j=m.has(At)}if(j){let At=ot.texture.type,Lt=_.has(At),Tt=B.getClearColor(),Dt=B.getClearAlpha(),zt=Tt.r,ne=Tt.g,ge=Tt.b;Lt?(x[0]=zt,x[1]=ne,x[2]=ge,x[3]=Dt,k.clearBufferuiv(k.COLOR,0,x)):(S[0]=zt,S[1]=ne,S[2]=ge,S[3]=Dt,k.clearBufferiv(k.COLOR,0,S))}else Z|=k.COLOR_BUFFER_BIT}H&&(Z|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),tt&&(Z|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&k.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),F=T},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),B.dispose(),vt.dispose(),nt.dispose(),qt.dispose(),Gt.dispose(),I.dispose(),dt.dispose(),q.dispose(),St.dispose(),Ht.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",ql),ct.removeEventListener("sessionend",rs),Cs.stop()};function Bt(T){T.preventDefault(),Xa("WebGLRenderer: Context Lost."),L=!0}function te(){Xa("WebGLRenderer: Context Restored."),L=!1;let T=He.autoReset,H=pt.enabled,tt=pt.autoUpdate,Z=pt.needsUpdate,j=pt.type;Qt(),He.autoReset=T,pt.enabled=H,pt.autoUpdate=tt,pt.needsUpdate=Z,pt.type=j}function Rt(T){ee("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ue(T){let H=T.target;H.removeEventListener("dispose",ue),Je(H)}function Je(T){Qn(T),Gt.remove(T)}function Qn(T){let H=Gt.get(T).programs;H!==void 0&&(H.forEach(function(tt){at.releaseProgram(tt)}),T.isShaderMaterial&&at.releaseShaderCache(T))}this.renderBufferDirect=function(T,H,tt,Z,j,At){H===null&&(H=Cn);let Lt=j.isMesh&&j.matrixWorld.determinantAffine()<0,Tt=Ta(T,H,tt,Z,j);Mt.setMaterial(Z,Lt);let Dt=tt.index,zt=1;if(Z.wireframe===!0){if(Dt=q.getWireframeAttribute(tt),Dt===void 0)return;zt=2}let ne=tt.drawRange,ge=tt.attributes.position,kt=ne.start*zt,_e=(ne.start+ne.count)*zt;At!==null&&(kt=Math.max(kt,At.start*zt),_e=Math.min(_e,(At.start+At.count)*zt)),Dt!==null?(kt=Math.max(kt,0),_e=Math.min(_e,Dt.count)):ge!=null&&(kt=Math.max(kt,0),_e=Math.min(_e,ge.count));let cn=_e-kt;if(cn<0||cn===1/0)return;St.setup(j,Z,Tt,tt,Dt);let Oe,Ue=it;if(Dt!==null&&(Oe=w.get(Dt),Ue=Et,Ue.setIndex(Oe)),j.isMesh)Z.wireframe===!0?(Mt.setLineWidth(Z.wireframeLinewidth*bn()),Ue.setMode(k.LINES)):Ue.setMode(k.TRIANGLES);else if(j.isLine){let Rn=Z.linewidth;Rn===void 0&&(Rn=1),Mt.setLineWidth(Rn*bn()),j.isLineSegments?Ue.setMode(k.LINES):j.isLineLoop?Ue.setMode(k.LINE_LOOP):Ue.setMode(k.LINE_STRIP)}else j.isPoints?Ue.setMode(k.POINTS):j.isSprite&&Ue.setMode(k.TRIANGLES);if(j.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))Ue.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let Rn=j._multiDrawStarts,Ut=j._multiDrawCounts,Sn=j._multiDrawCount,ye=Dt?w.get(Dt).bytesPerElement:1,Ps=Gt.get(Z).currentProgram.getUniforms();for(let wn=0;wn<Sn;wn++)Ps.setValue(k,"_gl_DrawID",wn),Ue.render(Rn[wn]/ye,Ut[wn])}else if(j.isInstancedMesh)Ue.renderInstances(kt,cn,j.count);else if(tt.isInstancedBufferGeometry){let Rn=tt._maxInstanceCount!==void 0?tt._maxInstanceCount:1/0,Ut=Math.min(tt.instanceCount,Rn);Ue.renderInstances(kt,cn,Ut)}else Ue.render(kt,cn)};function Ma(T,H,tt,Z){F!==null&&T.isNodeMaterial&&F.setObject(Z,T),Ye===!0&&st.setState(T,tt,!1),T.transparent===!0&&T.side===an&&T.forceSinglePass===!1?(T.side=li,T.needsUpdate=!0,os(T,H,Z),T.side=Sr,T.needsUpdate=!0,os(T,H,Z),T.side=an):os(T,H,Z)}this.compile=function(T,H,tt=null){tt===null&&(tt=T),F!==null&&F.renderStart(T,H,tt),A=nt.get(tt),A.init(H),M.push(A),tt.traverseVisible(function(j){j.isLight&&j.layers.test(H.layers)&&(A.pushLight(j),j.castShadow&&A.pushShadow(j))}),T!==tt&&T.traverseVisible(function(j){j.isLight&&j.layers.test(H.layers)&&(A.pushLight(j),j.castShadow&&A.pushShadow(j))}),A.setupLights(),F!==null&&F.updateLights(A.state.lightsArray),vn=this.localClippingEnabled,Ye=st.init(this.clippingPlanes,vn),Ye===!0&&st.setGlobalState(this.clippingPlanes,H),F!==null&&pt.render(A.state.shadowsArray,tt,H);let Z=new Set;return T.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let At=j.material;if(At)if(Array.isArray(At))for(let Lt=0;Lt<At.length;Lt++){let Tt=At[Lt];Ma(Tt,tt,H,j),Z.add(Tt)}else Ma(At,tt,H,j),Z.add(At)}),A=M.pop(),F!==null&&F.renderEnd(),Z},this.compileAsync=function(T,H,tt=null){let Z=this.compile(T,H,tt);return new Promise(j=>{function At(){if(Z.forEach(function(Lt){let Dt=Gt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&Z.delete(Lt)}),Z.size===0){j(T);return}setTimeout(At,10)}jt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let ho=null;function Zu(T){ho&&ho(T)}function ql(){Cs.stop()}function rs(){Cs.start()}let Cs=new C0;Cs.setAnimationLoop(Zu),typeof self<"u"&&Cs.setContext(self),this.setAnimationLoop=function(T){ho=T,ct.setAnimationLoop(T),T===null?Cs.stop():Cs.start()},ct.addEventListener("sessionstart",ql),ct.addEventListener("sessionend",rs),this.render=function(T,H){if(H!==void 0&&H.isCamera!==!0){ee("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;F!==null&&F.renderStart(T,H);let tt=ct.enabled===!0&&ct.isPresenting===!0,Z=U!==null&&(ot===null||tt)&&U.begin(P,ot);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(H),H=ct.getCamera()),T.isScene===!0&&T.onBeforeRender(P,T,H,ot),A=nt.get(T,M.length),A.init(H),A.state.textureUnits=qt.getTextureUnits(),M.push(A),ze.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?rn.setFromArrayCamera(H):re.setFromProjectionMatrix(ze,Oi,H.reversedDepth),vn=this.localClippingEnabled,Ye=st.init(this.clippingPlanes,vn),C=vt.get(T,v.length),C.init(),v.push(C),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Lt=P.xr.getDepthSensingMesh();Lt!==null&&Rs(Lt,H,-1/0,P.sortObjects)}Rs(T,H,0,P.sortObjects),C.finish(),F!==null&&F.updateLights(A.state.lightsArray),P.sortObjects===!0&&C.sort(Xt,ae),dn=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,dn&&B.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),Ye===!0&&st.beginShadows();let j=A.state.shadowsArray;if(pt.render(j,T,H),Ye===!0&&st.endShadows(),(Z&&U.hasRenderPass())===!1){let Lt=C.opaque,Tt=C.transmissive;if(A.setupLights(),H.isArrayCamera){let Dt=H.cameras;if(Tt.length>0)for(let zt=0,ne=Dt.length;zt<ne;zt++){let ge=Dt[zt];Xi(Lt,Tt,T,ge)}dn&&B.render(T);for(let zt=0,ne=Dt.length;zt<ne;zt++){let ge=Dt[zt];Ea(C,T,ge,ge.viewport)}}else Tt.length>0&&Xi(Lt,Tt,T,H),dn&&B.render(T),Ea(C,T,H)}ot!==null&&V===0&&(qt.updateMultisampleRenderTarget(ot),qt.updateRenderTargetMipmap(ot)),Z&&U.end(P),T.isScene===!0&&T.onAfterRender(P,T,H),St.resetDefaultState(),$=-1,K=null,M.pop(),M.length>0?(A=M[M.length-1],qt.setTextureUnits(A.state.textureUnits),Ye===!0&&st.setGlobalState(P.clippingPlanes,A.state.camera)):A=null,v.pop(),v.length>0?C=v[v.length-1]:C=null,F!==null&&F.renderEnd()};function Rs(T,H,tt,Z){if(T.visible===!1)return;if(T.layers.test(H.layers)){if(T.isGroup)tt=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(H);else if(T.isLight)A.pushLight(T),T.castShadow&&A.pushShadow(T);else if(T.isSprite){let Lt=H.isArrayCamera?rn:re;if(!T.frustumCulled||T.intersectsFrustum(Lt)){Z&&Se.setFromMatrixPosition(T.matrixWorld).applyMatrix4(ze);let Tt=dt.update(T),Dt=T.material;Dt.visible&&C.push(T,Tt,Dt,tt,Se.z,null,H)}}else if(T.isMesh||T.isLine||T.isPoints){let Lt=H.isArrayCamera?rn:re;if(!T.frustumCulled||T.intersectsFrustum(Lt)){let Tt=dt.update(T),Dt=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Se.copy(T.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),Se.copy(Tt.boundingSphere.center)),Se.applyMatrix4(T.matrixWorld).applyMatrix4(ze)),Array.isArray(Dt)){let zt=Tt.groups;for(let ne=0,ge=zt.length;ne<ge;ne++){let kt=zt[ne],_e=Dt[kt.materialIndex];_e&&_e.visible&&C.push(T,Tt,_e,tt,Se.z,kt,H)}}else Dt.visible&&C.push(T,Tt,Dt,tt,Se.z,null,H)}}}let At=T.children;for(let Lt=0,Tt=At.length;Lt<Tt;Lt++)Rs(At[Lt],H,tt,Z)}function Ea(T,H,tt,Z){let{opaque:j,transmissive:At,transparent:Lt}=T;A.setupLightsView(tt),Ye===!0&&st.setGlobalState(P.clippingPlanes,tt),Z&&Mt.viewport(et.copy(Z)),j.length>0&&fn(j,H,tt),At.length>0&&fn(At,H,tt),Lt.length>0&&fn(Lt,H,tt),Mt.buffers.depth.setTest(!0),Mt.buffers.depth.setMask(!0),Mt.buffers.color.setMask(!0),Mt.setPolygonOffset(!1)}function Xi(T,H,tt,Z){if((tt.isScene===!0?tt.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Z.id]===void 0){let kt=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Z.id]=new Mi(1,1,{generateMipmaps:!0,type:kt?Qi:fi,minFilter:$s,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ve.workingColorSpace})}let At=A.state.transmissionRenderTarget[Z.id],Lt=Z.viewport||et;At.setSize(Lt.z*P.transmissionResolutionScale,Lt.w*P.transmissionResolutionScale);let Tt=P.getRenderTarget(),Dt=P.getActiveCubeFace(),zt=P.getActiveMipmapLevel();P.setRenderTarget(At),P.getClearColor(Q),gt=P.getClearAlpha(),gt<1&&P.setClearColor(16777215,.5),P.clear(),dn&&B.render(tt);let ne=P.toneMapping;P.toneMapping=ms;let ge=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),A.setupLightsView(Z),Ye===!0&&st.setGlobalState(P.clippingPlanes,Z),fn(T,tt,Z),qt.updateMultisampleRenderTarget(At),qt.updateRenderTargetMipmap(At),jt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let _e=0,cn=H.length;_e<cn;_e++){let Oe=H[_e],{object:Ue,geometry:Rn,material:Ut,group:Sn}=Oe;if(Ut.side===an&&Ue.layers.test(Z.layers)){let ye=Ut.side;Ut.side=li,Ut.needsUpdate=!0,xn(Ue,tt,Z,Rn,Ut,Sn),Ut.side=ye,Ut.needsUpdate=!0,kt=!0}}kt===!0&&(qt.updateMultisampleRenderTarget(At),qt.updateRenderTargetMipmap(At))}P.setRenderTarget(Tt,Dt,zt),P.setClearColor(Q,gt),ge!==void 0&&(Z.viewport=ge),P.toneMapping=ne}function fn(T,H,tt){let Z=H.isScene===!0?H.overrideMaterial:null;for(let j=0,At=T.length;j<At;j++){let Lt=T[j],{object:Tt,geometry:Dt,group:zt}=Lt,ne=Lt.material;ne.allowOverride===!0&&Z!==null&&(ne=Z),Tt.layers.test(tt.layers)&&xn(Tt,H,tt,Dt,ne,zt)}}function xn(T,H,tt,Z,j,At){F!==null&&j.isNodeMaterial&&F.setObject(T,j),T.onBeforeRender(P,H,tt,Z,j,At),T.modelViewMatrix.multiplyMatrices(tt.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),j.onBeforeRender(P,H,tt,Z,T,At),j.transparent===!0&&j.side===an&&j.forceSinglePass===!1?(j.side=li,j.needsUpdate=!0,P.renderBufferDirect(tt,H,Z,j,T,At),j.side=Sr,j.needsUpdate=!0,P.renderBufferDirect(tt,H,Z,j,T,At),j.side=an):P.renderBufferDirect(tt,H,Z,j,T,At),T.onAfterRender(P,H,tt,Z,j,At)}function yn(T){let H=0;for(let tt of T)tt.texture!==null&&H++;return H}function os(T,H,tt){H.isScene!==!0&&(H=Cn);let Z=Gt.get(T),j=A.state.lights,At=A.state.shadowsArray,Lt=j.state.version,Tt=at.getParameters(T,j.state,At,H,tt,A.state.lightProbeGridArray),Dt=at.getProgramCacheKey(Tt),zt=Z.programs;Z.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?H.environment:null,Z.fog=H.fog;let ne=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Z.envMap=I.get(T.envMap||Z.environment,ne),Z.envMapRotation=Z.environment!==null&&T.envMap===null?H.environmentRotation:T.envMapRotation,zt===void 0&&(T.addEventListener("dispose",ue),zt=new Map,Z.programs=zt,Z.programVariants=new Map);let ge=zt.get(Dt);if(ge!==void 0){if(Z.currentProgram===ge&&Z.lightsStateVersion===Lt)return Aa(T,Tt),ge}else Tt.uniforms=at.getUniforms(T),F!==null&&T.isNodeMaterial&&F.build(T,tt,Tt),T.onBeforeCompile(Tt,P),ge=at.acquireProgram(Tt,Dt),zt.set(Dt,ge),Z.uniforms=Tt.uniforms;let kt=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(kt.clippingPlanes=st.uniform),Aa(T,Tt),Z.needsLights=ir(T),Z.lightsStateVersion=Lt,Z.needsLights&&(kt.ambientLightColor.value=j.state.ambient,kt.lightProbe.value=j.state.probe,kt.sunLights.value=j.state.sun,kt.sunLightShadows.value=j.state.sunShadow,kt.directionalLights.value=j.state.directional,kt.directionalLightShadows.value=j.state.directionalShadow,kt.spotLights.value=j.state.spot,kt.spotLightShadows.value=j.state.spotShadow,kt.rectAreaLights.value=j.state.rectArea,kt.ltc_1.value=j.state.rectAreaLTC1,kt.ltc_2.value=j.state.rectAreaLTC2,kt.pointLights.value=j.state.point,kt.pointLightShadows.value=j.state.pointShadow,kt.hemisphereLights.value=j.state.hemi,kt.sunShadowMatrix.value=j.state.sunShadowMatrix,kt.sunShadowCascade.value=j.state.sunShadowCascade,kt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,kt.spotLightMatrix.value=j.state.spotLightMatrix,kt.spotLightMap.value=j.state.spotLightMap,kt.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=yn(A.state.lightProbeGridArray),Z.currentProgram=ge,Z.uniformsList=null,ge}function mi(T,H,tt,Z,j){let At=Gt.get(T),Lt=At.currentProgram.id+","+Z+","+j,Tt=At.programVariants.get(Lt);return Tt===void 0?(Tt=os(T,H,tt),At.programVariants.set(Lt,Tt)):(At.currentProgram=Tt,At.uniformsList=null,At.outputColorSpace=Z,At.toneMapping=j),Tt}function nr(T){if(T.uniformsList===null){let H=T.currentProgram.getUniforms();T.uniformsList=na.seqWithValue(H.seq,T.uniforms)}return T.uniformsList}function Aa(T,H){let tt=Gt.get(T);tt.outputColorSpace=H.outputColorSpace,tt.batching=H.batching,tt.batchingColor=H.batchingColor,tt.instancing=H.instancing,tt.instancingColor=H.instancingColor,tt.instancingMorph=H.instancingMorph,tt.skinning=H.skinning,tt.morphTargets=H.morphTargets,tt.morphNormals=H.morphNormals,tt.morphColors=H.morphColors,tt.morphTargetsCount=H.morphTargetsCount,tt.numClippingPlanes=H.numClippingPlanes,tt.numIntersection=H.numClipIntersection,tt.vertexAlphas=H.vertexAlphas,tt.vertexTangents=H.vertexTangents,tt.toneMapping=H.toneMapping}function Ta(T,H,tt,Z,j){H.isScene!==!0&&(H=Cn),qt.resetTextureUnits();let At=H.fog,Lt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?H.environment:null,Tt=ot===null?P.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:ve.workingColorSpace,Dt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,zt=I.get(Z.envMap||Lt,Dt),ne=Z.vertexColors===!0&&!!tt.attributes.color&&tt.attributes.color.itemSize===4,ge=!!tt.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),kt=!!tt.morphAttributes.position,_e=!!tt.morphAttributes.normal,cn=!!tt.morphAttributes.color,Oe=ms;Z.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Oe=P.toneMapping);let Ue=tt.morphAttributes.position||tt.morphAttributes.normal||tt.morphAttributes.color,Rn=Ue!==void 0?Ue.length:0,Ut=Gt.get(Z),Sn=A.state.lights;if(Ye===!0&&(vn===!0||T!==K)){let Fe=T===K&&Z.id===$;st.setState(Z,T,Fe)}let ye=!1,Ps=!1;Z.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==Sn.state.version||j.isBatchedMesh&&Ut.batching===!1||!j.isBatchedMesh&&Ut.batching===!0||j.isBatchedMesh&&Ut.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ut.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ut.instancing===!1||!j.isInstancedMesh&&Ut.instancing===!0||j.isSkinnedMesh&&Ut.skinning===!1||!j.isSkinnedMesh&&Ut.skinning===!0||j.isInstancedMesh&&Ut.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ut.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ut.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ut.instancingMorph===!1&&j.morphTexture!==null||Ut.envMap!==zt||Z.fog===!0&&Ut.fog!==At||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==ne||Ut.vertexTangents!==ge||Ut.morphTargets!==kt||Ut.morphNormals!==_e||Ut.morphColors!==cn||Ut.morphTargetsCount!==Rn||Ut.numLightProbeGrids!==yn(A.state.lightProbeGridArray)?ye=!0:(Ut.outputColorSpace!==Tt||Ut.toneMapping!==Oe)&&(Ps=!0):(ye=!0,Ut.__version=Z.version);let wn=Ut.currentProgram;(ye===!0||Ps===!0)&&(wn=Ps===!0?mi(Z,H,j,Tt,Oe):os(Z,H,j),F&&Z.isNodeMaterial&&F.onUpdateProgram(Z,wn,Ut));let po=!1,as=!1,Is=!1,fe=wn.getUniforms(),pn=Ut.uniforms;if(Mt.useProgram(wn.program)&&(po=!0,as=!0,Is=!0),Z.id!==$&&($=Z.id,as=!0),po||K!==T){Mt.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),fe.setValue(k,"projectionMatrix",T.projectionMatrix),fe.setValue(k,"viewMatrix",T.matrixWorldInverse);let Mn=fe.map.cameraPosition;Mn!==void 0&&Mn.setValue(k,Un.setFromMatrixPosition(T.matrixWorld)),le.logarithmicDepthBuffer&&fe.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&fe.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),K!==T&&(K=T,as=!0,Is=!0)}if(Ut.needsLights&&(Sn.state.sunShadowMap.length>0&&fe.setValue(k,"sunShadowMap",Sn.state.sunShadowMap,qt),Sn.state.directionalShadowMap.length>0&&fe.setValue(k,"directionalShadowMap",Sn.state.directionalShadowMap,qt),Sn.state.spotShadowMap.length>0&&fe.setValue(k,"spotShadowMap",Sn.state.spotShadowMap,qt),Sn.state.pointShadowMap.length>0&&fe.setValue(k,"pointShadowMap",Sn.state.pointShadowMap,qt)),j.isSkinnedMesh){fe.setOptional(k,j,"bindMatrix"),fe.setOptional(k,j,"bindMatrixInverse");let Fe=j.skeleton;Fe&&(Fe.boneTexture===null&&Fe.computeBoneTexture(),fe.setValue(k,"boneTexture",Fe.boneTexture,qt))}j.isBatchedMesh&&(fe.setOptional(k,j,"batchingTexture"),fe.setValue(k,"batchingTexture",j._matricesTexture,qt),fe.setOptional(k,j,"batchingIdTexture"),fe.setValue(k,"batchingIdTexture",j._indirectTexture,qt),fe.setOptional(k,j,"batchingColorTexture"),j._colorsTexture!==null&&fe.setValue(k,"batchingColorTexture",j._colorsTexture,qt));let ti=tt.morphAttributes;if((ti.position!==void 0||ti.normal!==void 0||ti.color!==void 0)&&rt.update(j,tt,wn),(as||Ut.receiveShadow!==j.receiveShadow)&&(Ut.receiveShadow=j.receiveShadow,fe.setValue(k,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&H.environment!==null&&(pn.envMapIntensity.value=H.environmentIntensity),pn.dfgLUT!==void 0&&(pn.dfgLUT.value=QA()),as){if(fe.setValue(k,"toneMappingExposure",P.toneMappingExposure),Ut.needsLights&&uo(pn,Is),At&&Z.fog===!0&&xt.refreshFogUniforms(pn,At),xt.refreshMaterialUniforms(pn,Z,wt,Ct,A.state.transmissionRenderTarget[T.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Fe=y,Mn=0;for(let Yn of A.state.lightProbeGridArray)Yn.texture!==null&&(Fe.textures[Mn]=Yn.texture,Fe.min[Mn]=Yn.boundingBox.min,Fe.max[Mn]=Yn.boundingBox.max,Fe.resolution[Mn]=Yn.resolution,Mn++);for(let Yn in Fe)Fe[Yn].length=Mn;pn.probesSH.value=Fe.textures,pn.probesMin.value=Fe.min,pn.probesMax.value=Fe.max,pn.probesResolution.value=Fe.resolution}na.upload(k,nr(Ut),pn,qt)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(na.upload(k,nr(Ut),pn,qt),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&fe.setValue(k,"center",j.center),fe.setValue(k,"modelViewMatrix",j.modelViewMatrix),fe.setValue(k,"normalMatrix",j.normalMatrix),fe.setValue(k,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let Fe=Z.uniformsGroups;for(let Mn=0,Yn=Fe.length;Mn<Yn;Mn++){let Yl=Fe[Mn];Ht.update(Yl,wn),Ht.bind(Yl,wn)}}return wn}function uo(T,H){T.ambientLightColor.needsUpdate=H,T.lightProbe.needsUpdate=H,T.sunLights.needsUpdate=H,T.sunLightShadows.needsUpdate=H,T.directionalLights.needsUpdate=H,T.directionalLightShadows.needsUpdate=H,T.pointLights.needsUpdate=H,T.pointLightShadows.needsUpdate=H,T.spotLights.needsUpdate=H,T.spotLightShadows.needsUpdate=H,T.rectAreaLights.needsUpdate=H,T.hemisphereLights.needsUpdate=H}function ir(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ot},this.setRenderTargetTextures=function(T,H,tt){let Z=Gt.get(T);Z.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Gt.get(T.texture).__webglTexture=H,Gt.get(T.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:tt,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,H){let tt=Gt.get(T);tt.__webglFramebuffer=H,tt.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(T,H=0,tt=0){ot=T,Y=H,V=tt;let Z=null,j=!1,At=!1;if(T){let Tt=Gt.get(T);if(Tt.__useDefaultFramebuffer!==void 0){Mt.bindFramebuffer(k.FRAMEBUFFER,Tt.__webglFramebuffer),et.copy(T.viewport),ht.copy(T.scissor),ut=T.scissorTest,Mt.viewport(et),Mt.scissor(ht),Mt.setScissorTest(ut),$=-1;return}else if(Tt.__webglFramebuffer===void 0)qt.setupRenderTarget(T);else if(Tt.__hasExternalTextures)qt.rebindTextures(T,Gt.get(T.texture).__webglTexture,Gt.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let ne=T.depthTexture;if(Tt.__boundDepthTexture!==ne){if(ne!==null&&Gt.has(ne)&&(T.width!==ne.image.width||T.height!==ne.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(T)}}let Dt=T.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(At=!0);let zt=Gt.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(zt[H])?Z=zt[H][tt]:Z=zt[H],j=!0):T.samples>0&&qt.useMultisampledRTT(T)===!1?Z=Gt.get(T).__webglMultisampledFramebuffer:Array.isArray(zt)?Z=zt[tt]:Z=zt,et.copy(T.viewport),ht.copy(T.scissor),ut=T.scissorTest}else et.copy(Vt).multiplyScalar(wt).floor(),ht.copy(me).multiplyScalar(wt).floor(),ut=de;if(tt!==0&&(Z=G),Mt.bindFramebuffer(k.FRAMEBUFFER,Z)&&Mt.drawBuffers(T,Z),Mt.viewport(et),Mt.scissor(ht),Mt.setScissorTest(ut),j){let Tt=Gt.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Tt.__webglTexture,tt)}else if(At){let Tt=H;for(let Dt=0;Dt<T.textures.length;Dt++){let zt=Gt.get(T.textures[Dt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Dt,zt.__webglTexture,tt,Tt)}}else if(T!==null&&tt!==0){let Tt=Gt.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Tt.__webglTexture,tt)}$=-1};function fo(T){let H=Gt.get(T);return(H.__readFormat!==T.format||H.__readType!==T.type)&&(H.__readFormat=T.format,H.__readType=T.type,H.__formatReadable=le.textureFormatReadable(T.format),H.__typeReadable=le.textureTypeReadable(T.type)),H}this.readRenderTargetPixels=function(T,H,tt,Z,j,At,Lt,Tt=0){if(!(T&&T.isWebGLRenderTarget)){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Gt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){Mt.bindFramebuffer(k.FRAMEBUFFER,Dt);try{let zt=T.textures[Tt],ne=zt.format,ge=zt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let kt=fo(zt);if(kt.__formatReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=T.width-Z&&tt>=0&&tt<=T.height-j&&k.readPixels(H,tt,Z,j,_t.convert(ne),_t.convert(ge),At)}finally{let zt=ot!==null?Gt.get(ot).__webglFramebuffer:null;Mt.bindFramebuffer(k.FRAMEBUFFER,zt)}}},this.readRenderTargetPixelsAsync=async function(T,H,tt,Z,j,At,Lt,Tt=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Gt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(H>=0&&H<=T.width-Z&&tt>=0&&tt<=T.height-j){Mt.bindFramebuffer(k.FRAMEBUFFER,Dt);let zt=T.textures[Tt],ne=zt.format,ge=zt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let kt=fo(zt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.bufferData(k.PIXEL_PACK_BUFFER,At.byteLength,k.STREAM_READ),k.readPixels(H,tt,Z,j,_t.convert(ne),_t.convert(ge),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let cn=ot!==null?Gt.get(ot).__webglFramebuffer:null;Mt.bindFramebuffer(k.FRAMEBUFFER,cn);let Oe=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await n0(k,Oe,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,At),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(_e),k.deleteSync(Oe),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,H=null,tt=0){let Z=Math.pow(2,-tt),j=Math.floor(T.image.width*Z),At=Math.floor(T.image.height*Z),Lt=H!==null?H.x:0,Tt=H!==null?H.y:0;qt.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,tt,0,0,Lt,Tt,j,At),Mt.unbindTexture()},this.copyTextureToTexture=function(T,H,tt=null,Z=null,j=0,At=0){let Lt,Tt,Dt,zt,ne,ge,kt,_e,cn,Oe=T.isCompressedTexture?T.mipmaps[At]:T.image;if(tt!==null)Lt=tt.max.x-tt.min.x,Tt=tt.max.y-tt.min.y,Dt=tt.isBox3?tt.max.z-tt.min.z:1,zt=tt.min.x,ne=tt.min.y,ge=tt.isBox3?tt.min.z:0;else{let fe=Math.pow(2,-j);Lt=Math.floor(Oe.width*fe),Tt=Math.floor(Oe.height*fe),T.isDataArrayTexture?Dt=Oe.depth:T.isData3DTexture?Dt=Math.floor(Oe.depth*fe):Dt=1,zt=0,ne=0,ge=0}Z!==null?(kt=Z.x,_e=Z.y,cn=Z.z):(kt=0,_e=0,cn=0);let Ue=_t.convert(H.format),Rn=_t.convert(H.type),Ut;H.isData3DTexture?(qt.setTexture3D(H,0),Ut=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(qt.setTexture2DArray(H,0),Ut=k.TEXTURE_2D_ARRAY):(qt.setTexture2D(H,0),Ut=k.TEXTURE_2D),Mt.activeTexture(k.TEXTURE0),Mt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),Mt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Mt.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let Sn=Mt.getParameter(k.UNPACK_ROW_LENGTH),ye=Mt.getParameter(k.UNPACK_IMAGE_HEIGHT),Ps=Mt.getParameter(k.UNPACK_SKIP_PIXELS),wn=Mt.getParameter(k.UNPACK_SKIP_ROWS),po=Mt.getParameter(k.UNPACK_SKIP_IMAGES);Mt.pixelStorei(k.UNPACK_ROW_LENGTH,Oe.width),Mt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Oe.height),Mt.pixelStorei(k.UNPACK_SKIP_PIXELS,zt),Mt.pixelStorei(k.UNPACK_SKIP_ROWS,ne),Mt.pixelStorei(k.UNPACK_SKIP_IMAGES,ge);let as=T.isDataArrayTexture||T.isData3DTexture,Is=H.isDataArrayTexture||H.isData3DTexture;if(T.isDepthTexture){let fe=Gt.get(T),pn=Gt.get(H),ti=Gt.get(fe.__renderTarget),Fe=Gt.get(pn.__renderTarget);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,ti.__webglFramebuffer),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Mn=0;Mn<Dt;Mn++)as&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(T).__webglTexture,j,ge+Mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(H).__webglTexture,At,cn+Mn)),k.blitFramebuffer(zt,ne,zt+Lt,ne+Tt,kt,_e,kt+Lt,_e+Tt,k.DEPTH_BUFFER_BIT,k.NEAREST);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(j!==0||T.isRenderTargetTexture||Gt.has(T)){let fe=Gt.get(T),pn=Gt.get(H);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,N),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,z);for(let ti=0;ti<Dt;ti++)as?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,fe.__webglTexture,j,ge+ti):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,fe.__webglTexture,j),Is?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pn.__webglTexture,At,cn+ti):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pn.__webglTexture,At),j!==0?k.blitFramebuffer(zt,ne,zt+Lt,ne+Tt,kt,_e,kt+Lt,_e+Tt,k.COLOR_BUFFER_BIT,k.NEAREST):Is?k.copyTexSubImage3D(Ut,At,kt,_e,cn+ti,zt,ne,Lt,Tt):k.copyTexSubImage2D(Ut,At,kt,_e,zt,ne,Lt,Tt);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Is?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(Ut,At,kt,_e,cn,Lt,Tt,Dt,Ue,Rn,Oe.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Ut,At,kt,_e,cn,Lt,Tt,Dt,Ue,Oe.data):k.texSubImage3D(Ut,At,kt,_e,cn,Lt,Tt,Dt,Ue,Rn,Oe):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,At,kt,_e,Lt,Tt,Ue,Rn,Oe.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,At,kt,_e,Oe.width,Oe.height,Ue,Oe.data):k.texSubImage2D(k.TEXTURE_2D,At,kt,_e,Lt,Tt,Ue,Rn,Oe);Mt.pixelStorei(k.UNPACK_ROW_LENGTH,Sn),Mt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ye),Mt.pixelStorei(k.UNPACK_SKIP_PIXELS,Ps),Mt.pixelStorei(k.UNPACK_SKIP_ROWS,wn),Mt.pixelStorei(k.UNPACK_SKIP_IMAGES,po),At===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Ut),Mt.unbindTexture()},this.initRenderTarget=function(T){Gt.get(T).__webglFramebuffer===void 0&&qt.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?qt.setTextureCube(T,0):T.isData3DTexture?qt.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?qt.setTexture2DArray(T,0):qt.setTexture2D(T,0),Mt.unbindTexture()},this.resetState=function(){Y=0,V=0,ot=null,Mt.reset(),St.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Oi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var tT=["fill","fill-opacity","fill-rule","stroke","stroke-width","stroke-opacity","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","paint-order","display","font-family","font-size","font-weight","font-style","text-anchor"];function k0(n,t){let e=getComputedStyle(n);for(let i of tT)t.style.setProperty(i,e.getPropertyValue(i));t.style.removeProperty("color"),t.removeAttribute("class"),[...n.children].forEach((i,s)=>k0(i,t.children[s]))}function z0(n,t,e){let i=n.cloneNode(!0);k0(n,i);let s={x:t.x-e.x,y:t.y-e.y,width:t.width,height:t.height};for(let[r,o]of Object.entries(s))i.setAttribute(r,o);return i}function G0(n,t,e,i){let s=n.getBoundingClientRect(),{color:r,fontFamily:o,fontSize:a,fontWeight:l}=getComputedStyle(n),c={x:e-i.x,y:s.y+s.height/2+4-i.y,fill:r},u=`font-family: ${o}; font-size: ${a}; font-weight: ${l}`;return hn("text",{...c,style:u},t)}function eT(n,t,e){if(n instanceof SVGElement)return z0(n,t,e);let i=getComputedStyle(n).getPropertyValue("--swatch").trim(),[s,r]=[t.x-e.x,t.y-e.y],o=r+t.height/2;return n.matches(".dash, .thin, .thick")?hn("line",{x1:s,x2:s+t.width,y1:o,y2:o,stroke:i,"stroke-width":n.matches(".thick")?6:2.5,"stroke-opacity":n.matches(".thick")?.55:1,"stroke-dasharray":n.matches(".dash")?"5 4":null}):n.matches(".dot, .ring")?hn("circle",{cx:s+t.width/2,cy:o,r:t.width/2-1,stroke:i,fill:n.matches(".ring")?"none":i,"stroke-width":2}):hn("rect",{x:s,y:r,width:t.width,height:t.height,rx:2,fill:i})}function nT(n,t){let e=n.firstElementChild,i=e.getBoundingClientRect(),{opacity:s}=getComputedStyle(n),r=G0(n,n.textContent,i.right+6,t);return hn("g",{opacity:s},eT(e,i,t),r)}function iT(n,t){let e=[...n.querySelectorAll(".plane > h3")].map(s=>[s,s.textContent]),i=[...n.querySelectorAll(".chooser select")].map(s=>[s,s.selectedOptions[0]?.textContent??""]);return[...e,...i].map(([s,r])=>G0(s,r,s.getBoundingClientRect().left,t))}function sT(n){let t=getComputedStyle(document.documentElement);for(let e of n.querySelectorAll("[fill^='var('], [stroke^='var(']"))for(let i of["fill","stroke"]){let s=e.getAttribute(i)?.match(/^var\((--[\w-]+)\)$/)?.[1];s&&e.setAttribute(i,t.getPropertyValue(s).trim())}return n}function wl(n){let t=[...n.querySelectorAll(".chart")].filter(g=>g.toSvg),e=t.map(g=>g.getBoundingClientRect()),i=t.map(g=>g.appendChild(g.toSvg())),s=new Map(i.map((g,m)=>[g,e[m]])),r=[...n.querySelectorAll("svg.plot")].filter(g=>!g.closest("button")),o=[...n.querySelectorAll(".legend > *")],a=g=>s.get(g)??g.getBoundingClientRect(),l=n.querySelectorAll(".plane > h3, .chooser select"),c=[...r,...o,...l].map(a),u={x:Math.min(...c.map(g=>g.left))-8,y:Math.min(...c.map(g=>g.top))-8},d=Math.max(...c.map(g=>g.right))+8-u.x,h=Math.max(...c.map(g=>g.bottom))+8-u.y,f=getComputedStyle(document.documentElement).getPropertyValue("--page").trim(),p=hn("svg",{xmlns:"http://www.w3.org/2000/svg",width:d,height:h,viewBox:`0 0 ${d} ${h}`},hn("rect",{width:d,height:h,fill:f}),...iT(n,u),...o.map(g=>nT(g,u)),...r.map(g=>z0(g,a(g),u)));return i.forEach(g=>g.remove()),new XMLSerializer().serializeToString(sT(p))}var ra=(...n)=>n.map(t=>({name:t})),Nf=(n,t)=>n.map(e=>t[e]??null);function rT({series:n,x_label:t,y_label:e}){let i=n.flatMap(r=>r.x.map((o,a)=>[r.name,o,r.y[a],r.band_low?.[a]??null,r.band_high?.[a]??null,r.labels?.[a]??r.hints?.[a]??null]));return{columns:ra("series",t||"x",e||"y","band_low","band_high","label"),rows:i}}var V0=["series","value","low","high"],oT=({groups:n})=>({columns:ra("group",...V0),rows:n.flatMap(t=>t.values.map(e=>[t.name,...Nf(V0,e)]))}),H0=["name","unit","estimate","low","high","inner_low","inner_high","prior_low","prior_high","truth","display"],aT=({rows:n})=>({columns:ra(...H0),rows:n.map(t=>Nf(H0,t))}),W0=["measured","predicted","sd","predicted_sd"],lT=({planes:n})=>({columns:ra("plane","panel","group",...W0.flatMap(t=>[`${t}_x`,`${t}_y`])),rows:n.flatMap(t=>t.panels.flatMap(e=>e.arrows.map(i=>[t.name,e.title,i.group,...W0.flatMap(s=>i[s]??[null,null])])))}),X0=["measured","median","inner_low","inner_high","low","high"],cT=({components:n,groups:t})=>({columns:ra("group","row","component",...X0),rows:t.flatMap(e=>e.rows.flatMap(i=>i.values.map((s,r)=>[e.name,i.name,n[r],...Nf(X0,s)])))}),hT=({chains:n,draws:t,quantities:e})=>({columns:ra("quantity","unit","chain","draw","value"),rows:e.flatMap(i=>i.traces.flatMap((s,r)=>s.map((o,a)=>[i.name,i.unit??null,n[r],t[a],o])))}),uT=({quantities:n})=>({columns:n.map(({name:t,unit:e})=>({name:t,unit:e})),rows:n[0].draws.map((t,e)=>n.map(i=>i.draws[e]))}),dT={lines:rT,bars:oT,interval:aT,vectors:lT,predictive:cT,chains:hT,corner:uT},Of=n=>dT[n.type]?.(n)??null,Ml=(n,t)=>(n??"").toLowerCase().split(/[^a-z0-9]+/).filter(Boolean).slice(0,6).join("-")||t;var Kh=()=>typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported("video/webm");function $0(n,t){let e=document.createElement("canvas");e.width=n.width,e.height=n.height;let i=e.getContext("2d"),s=()=>{i.fillStyle=t,i.fillRect(0,0,e.width,e.height),i.drawImage(n,0,0,e.width,e.height)};s();let r={mimeType:"video/webm",videoBitsPerSecond:8e6},o=new MediaRecorder(e.captureStream(30),r),a=[];o.addEventListener("dataavailable",({data:u})=>a.push(u));let l=new Promise((u,d)=>{o.addEventListener("error",({error:h})=>d(h??new Error("no film"))),o.addEventListener("stop",()=>u(new Blob(a,{type:"video/webm"})))});return l.catch(()=>{}),o.start(),{frame:s,stop:()=>{o.state!=="inactive"&&o.stop()},film:l}}var fT=n=>{let t=n==null?"":String(n);return/[",\r\n]/.test(t)?`"${t.replace(/"/g,'""')}"`:t};function q0({columns:n,rows:t}){return[n.map(({name:i,unit:s})=>s?`${i} [${s}]`:i),...t].map(i=>i.map(fT).join(",")).join(`\r
`)+`\r
`}async function pT(n){let t=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"})),e=new Image;e.src=t;try{await e.decode()}finally{URL.revokeObjectURL(t)}return e}async function Y0(n){let t=await pT(n),e=document.createElement("canvas");return e.width=Math.ceil(2*t.naturalWidth),e.height=Math.ceil(2*t.naturalHeight),e.getContext("2d").drawImage(t,0,0,e.width,e.height),new Promise((i,s)=>e.toBlob(r=>r?i(r):s(new Error("no picture")),"image/png"))}function Ci(n,t,e){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e}));X("a",{href:i,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e3)}var El=(n,t,e)=>X("button",{type:"button",title:`Save ${t}`,onclick:e},n);function mT(n,t){let e=Ml(n.caption,n.type),i=()=>Ci(`${e}.svg`,wl(t),"image/svg+xml"),s=async()=>Ci(`${e}.png`,await Y0(wl(t))),r=()=>Ci(`${e}.csv`,q0(Of(n)),"text/csv");return[El("SVG","the figure as a drawing",i),El("PNG","the figure as a picture",s),El("CSV","the numbers of the figure",r)]}function gT(n,t){let e=X("output",{}),i=El("WebM","the motion as a film, while it plays once",async()=>{i.disabled=!0,e.textContent="";try{let s=await n.toMovie?.();s&&Ci(`${t}.webm`,s)}catch(s){e.textContent=`No film was saved: ${s.message}`}finally{i.disabled=!1}});return[i,e]}function _T(n,t){let e=t.querySelector(".scene"),i=Ml(n.caption,"scene"),r=[El("PNG","the picture as it stands",()=>e.toPng?.(o=>Ci(`${i}.png`,o)))];return n.strip&&Kh()&&r.push(...gT(e,i)),r}function Z0(n,t){let e=n.type==="scene"?_T(n,t):Of(n)?mT(n,t):[];return e.length&&t.append(X("div",{class:"tools save",role:"group","aria-label":"Save"},...e)),t}var j0=(n,t)=>new Promise(e=>n.stage.picture().toBlob(i=>{Ci(`${t}.png`,i),e(i.size)},"image/png"));function J0(){let n=[...document.querySelectorAll("figure.figure")].filter(t=>t.offsetParent&&[...t.querySelectorAll(".chart")].some(e=>e.toSvg));for(let t of n){let e=t.querySelector("figcaption")?.textContent??"";Ci(`${Ml(e,"chart")}.svg`,wl(t),"image/svg+xml")}return n.length}async function K0(n,t){let e=await n("picture.gltf");return e&&Ci(`${t}.gltf`,e.gltf,"model/gltf+json"),!!e}var xT=600;function Q0({canvas:n,words:t},e){let i=document.createElement("canvas");i.width=t.width,i.height=t.height;let s=i.getContext("2d");return{copy:i,take:()=>{s.clearRect(0,0,i.width,i.height),e&&(s.fillStyle=e,s.fillRect(0,0,i.width,i.height)),s.drawImage(n,0,0,i.width,i.height),s.drawImage(t,0,0,i.width,i.height)}}}function yT(n){let{copy:t,take:e}=Q0(n),i=$0(t,en("--page"));return{frame:()=>{e(),i.frame()},end:async o=>{i.stop();let a=await i.film;return Ci(`${o}.webm`,a),a.size}}}function vT(n){let{copy:t,take:e}=Q0(n,en("--page")),i=[];return{frame:()=>{i.length>=xT||(e(),i.push(new Promise(o=>t.toBlob(o,"image/png"))))},end:async o=>{let a=await Promise.all(i);return a.forEach((l,c)=>Ci(`${o}_${String(c+1).padStart(4,"0")}.png`,l)),a.length}}}function t_({stage:n}){let{frame:t,end:e}=Kh()?yT(n):vT(n);return n.painted.push(t),n.draw(),i=>(n.painted.splice(n.painted.indexOf(t),1),e(i))}var oa=n=>typeof n=="number"&&Number.isFinite(n),n_=n=>n.replace(/-/g,"\u2212"),Uf=n=>n.replace(/(\.\d*?)0+(?=e|$)/,"$1").replace(/\.(?=e|$)/,"").replace("e+","e");function ST(n,t){let e=Math.abs(n);return e!==0&&(e<.001||e>=1e6)?Uf(n.toExponential(t-1)):Uf(n.toPrecision(t).includes("e")?n.toFixed(0):n.toPrecision(t))}function wT(n,t){let e=n.toFixed(t);return Number(e)===0&&n!==0?Uf(n.toExponential(1)):e}var MT=1e-12,ET=1e-6;function AT(n,t,e){let i=t==null?0:ET*10**-t;return Math.abs(n)<Math.max(i,MT*e)}function he(n,t,e=0){if(!oa(n))return"n/a";let i=AT(n,t,e)?0:n;return n_(t==null?ST(i,4):wT(i,t))}var Ff=n=>n.reduce((t,e)=>oa(e)?Math.max(t,Math.abs(e)):t,0);var e_=12;function TT(n,t){for(let e=0;e<e_;++e)if(n.every(i=>Math.abs(i-Number(i.toFixed(e)))<1e-6*t))return e;return e_}function Bf(n){let t=Ff(n),e=n.slice(1).map((l,c)=>Math.abs(l-n[c])),i=Math.min(...e.filter(l=>l>0),t||1),s=t!==0&&(t<.001||t>=1e6)?Math.floor(Math.log10(t)):0,r=n.map(l=>Math.abs(l)<1e-6*i?0:l/10**s),o=TT(r,i/10**s),a=l=>s&&l!==0?`e${s}`:"";return r.map(l=>n_(`${l.toFixed(l===0&&s?0:o)}${a(l)}`))}var CT=Math.PI/180,Vi={angle:{unit:"\xB0",scale:CT,digits:1,step:1,big:10},length:{unit:"mm",scale:.001,digits:1,step:1,big:10},force:{unit:"N",scale:1,digits:2,step:.5,big:5},share:{unit:"",scale:1,digits:2,step:.01,big:.1}},Zs=({slides:n})=>n?Vi.length:Vi.angle;function aa(n,t){if(!Number.isFinite(n))return"n/a";let{unit:e,scale:i,digits:s}=t,r=n/i,o=Math.abs(r)<.5*10**-s?0:r,a=he(o,s);return e===""?a:e==="\xB0"?`${a}${e}`:`${a}\u202F${e}`}function i_(n,{scale:t}){let e=Number(String(n).trim().replace("\u2212","-").replace(",","."));return String(n).trim()===""||!Number.isFinite(e)?null:e*t}var _s=(n,t,e)=>Math.min(e,Math.max(t,n));var RT=0,js=n=>`${n}-${++RT}`,De=(n,t,e={})=>X("button",{type:"button",onclick:t,...e},n);function ke(n,t,e={}){let i=De(n,async()=>{if(!i.disabled){i.disabled=!0;try{await t()}finally{i.disabled=!1}}},e);return i}function la(n){let t=ke("Back to the world",()=>n.ask("session.mode",{mode:"world"})),e=()=>t.hidden=(n.store.scene?.mode??"world")==="world";return n.store.on(["scene"],e),e(),t}function Qh(n,t){let e=js("file"),i=X("input",{id:e,type:"text",autocomplete:"off",placeholder:"file"}),s=()=>i.value.trim()&&t(i.value.trim());return i.addEventListener("keydown",({key:r})=>r==="Enter"&&s()),X("div",{class:"choice file-row"},X("label",{for:e},n),i,ke("Open",s,{"aria-label":`Open ${n.toLowerCase()}`}))}var We=(n,...t)=>X("section",{class:"part","aria-label":n},X("h3",{},n),...t);function PT(n){let t=[];for(let{value:e,text:i,group:s}of n){let r=X("option",{value:e},i);s?t.at(-1)?.label===s?t.at(-1).append(r):t.push(X("optgroup",{label:s},r)):t.push(r)}return t}function Ln(n,t){let e=js("choice"),i=X("select",{id:e,onchange:()=>t(i.value)}),s=X("div",{class:"choice"},X("label",{for:e},n),i);return s.set=(r,o)=>{let a=r.map(c=>typeof c=="string"?{value:c,text:c}:c),l=JSON.stringify(a);i.dataset.key!==l&&(i.dataset.key=l,i.replaceChildren(...PT(a))),o!=null&&(i.value=o)},s.value=()=>i.value,s.select=i,s}function Al(n,t,e){let i=X("input",{type:"checkbox",onchange:()=>e(i.checked)});i.checked=t;let s=X("label",{class:"tick"},i,n);return s.box=i,s}var s_={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1};function IT(n,t,{lower:e,upper:i},s){let{step:r,big:o,scale:a}=s;return n.ctrlKey||n.altKey||n.metaKey?null:n.key==="Home"?e:n.key==="End"?i:n.key in s_?_s(t+s_[n.key]*r*a*(n.shiftKey?.1:1),e,i):n.key==="PageUp"?_s(t+o*a,e,i):n.key==="PageDown"?_s(t-o*a,e,i):null}function xs({name:n,title:t,lower:e,upper:i,quantity:s,note:r,off:o},a){let{scale:l,unit:c,digits:u}=s,d=_s(0,e,i),h=!1,f=`${aa(e,s)} to ${aa(i,s)}`,p=X("input",{type:"range",min:e/l,max:i/l,step:"any",disabled:o,"aria-label":`${n} ${c}`.trim(),title:f}),g=X("input",{type:"text",inputmode:"decimal",class:"value",disabled:o,"aria-label":`${n}, typed ${c}`.trim(),title:f,autocomplete:"off"}),m=()=>{p.value=d/l,p.setAttribute("aria-valuetext",aa(d,s)),document.activeElement!==g&&(g.value=(d/l).toFixed(u));let y=i>e?(d-e)/(i-e):0;p.style.setProperty("--full",`${100*y}%`)},_=y=>{d=_s(y,e,i),m(),a(d)};p.addEventListener("input",()=>_(Number(p.value)*l)),p.addEventListener("pointerdown",()=>h=!0);for(let y of["pointerup","pointercancel","blur","change"])p.addEventListener(y,()=>h=!1);p.addEventListener("keydown",y=>{let C=IT(y,d,{lower:e,upper:i},s);C!==null&&(y.preventDefault(),_(C))});let x=()=>{let y=i_(g.value,s);y!==null&&Math.abs(y-d)>.5*l*10**-u&&_(y),g.value=(d/l).toFixed(u)};g.addEventListener("change",x),g.addEventListener("keydown",y=>{y.key==="Enter"&&x(),y.key==="Escape"&&(g.value=(d/l).toFixed(u))});let S=X("div",{class:o?"slider off":"slider"},X("span",{class:"name",title:t??n},n),p,g,X("span",{class:"unit"},c),r?X("span",{class:"note"},r):null);return S.dataset.name=n,S.set=y=>{h||!Number.isFinite(y)||y===d||(d=y,m())},S.value=()=>d,S.mark=y=>S.classList.toggle("marked",y),m(),S}function r_(n,t,e){let i=n.map(({id:a,title:l,element:c})=>(Object.assign(c,{id:`page-${a}`,tabIndex:-1}),c.setAttribute("role","tabpanel"),c.setAttribute("aria-labelledby",`tab-${a}`),De(l,()=>r(a),{role:"tab",id:`tab-${a}`,"aria-controls":`page-${a}`}))),s=null;function r(a){s!==a&&(s=a,n.forEach((l,c)=>{let u=l.id===a;l.element.hidden=!u,i[c].setAttribute("aria-selected",String(u)),i[c].tabIndex=u?0:-1}),e(a))}let o=X("div",{class:"tabs",role:"tablist","aria-label":t},...i);return o.addEventListener("keydown",({key:a})=>{let l={ArrowLeft:-1,ArrowRight:1}[a];if(!l)return;let u=(i.indexOf(document.activeElement)+l+i.length)%i.length;i[u].focus(),r(n[u].id)}),{list:o,choose:r,chosen:()=>s}}function tu(n){if(!n?.length)return[];let t=n.map(e=>X("p",{class:"warning"},e));return t.length===1?t:[X("details",{class:"warnings"},X("summary",{},`${t.length} remarks`),...t)]}var Js=(n,t,e)=>X("div",{class:"table-frame",tabindex:0,role:"region","aria-label":e},X("table",{},X("thead",{},X("tr",{},...n.map(i=>X("th",{scope:"col"},i)))),X("tbody",{},...t.map(i=>X("tr",{},...i.map(s=>X("td",{},s)))))));function Ks(n,t){for(;n.rows.length>t.length;)n.deleteRow(-1);t.forEach((e,i)=>{let s=n.rows[i]??n.insertRow();e.forEach((r,o)=>{let a=s.cells[o]??s.insertCell();a.textContent!==r&&(a.textContent=r)})})}var ys=n=>X("dl",{class:"facts"},...n.flatMap(([t,e])=>[X("dt",{},t),X("dd",{},e)]));var LT=[["Everywhere",[["Tab, Shift+Tab","go through everything that can be used"],["?","this help"],["Ctrl+Z, Ctrl+Y","undo, redo"],["Ctrl+O, Ctrl+S","open, save"],["Esc","deselect; close a dialog"],["1 to 5","the tabs Pose, Grasp, Tendons, Fit, Time"],["G, O, C","grasp, open the hand, close it"],["Space","play or pause; . one step of time"]]],["On the picture",[["drag, right drag, wheel","turn, move, zoom the view"],["click","select a body and its joint"],["arrow keys","turn the view; with a selection move it"],["+ and \u2212","zoom; with a joint selected turn that by 1\xB0 or 1 mm (Shift: 10)"],["0 or Home","show everything"],["PageUp, PageDown","the previous and the next thing"],["[ and ]","the previous and the next joint of the hand"],["x, y, z","choose the axis that arrow keys move along or turn about"],["t, r","arrow keys move, or turn, what is selected"],["Left, Right","by 1 mm or 1\xB0; Up, Down: by 10 mm or 10\xB0"],["Shift while dragging","steps of 10 mm and 15\xB0"]]],["On a slider",[["arrow keys","one step; with Shift a tenth"],["PageUp, PageDown","ten steps up, ten steps down"],["Home, End","to the limits"]]]];function kf(n,...t){let e=js("dialog"),i=X("dialog",{"aria-labelledby":e},X("div",{class:"dialog-head"},X("h2",{id:e},n),De("\xD7",()=>i.close(),{"aria-label":"Close"})),...t);return document.body.append(i),i}function o_(){let n=kf("Keys and gestures",X("div",{class:"help"},...LT.flatMap(([t,e])=>[X("h3",{},t),X("dl",{},...e.flatMap(([i,s])=>[X("dt",{},i),X("dd",{},s)]))])));return n.classList.add("help-dialog"),()=>n.showModal()}function Tl(n,t,e="Cancel"){return new Promise(i=>{let s=kf(n,X("div",{class:"buttons"},De(t,()=>s.close("yes"),{class:"main"}),De(e,()=>s.close(""))));s.addEventListener("close",()=>{s.remove(),i(s.returnValue==="yes")}),s.showModal()})}function a_(n){return new Promise(t=>{let e=js("file"),i=X("input",{id:e,type:"text",value:n,autocomplete:"off"}),s=null,r=a=>{if(!i.value.trim())return i.focus();s={name:i.value.trim(),where:a},o.close()},o=kf("Save the world",X("div",{class:"choice"},X("label",{for:e},"File"),i),X("p",{class:"hint"},"A relative path that ends in .toml, below the folder thenar was started in."),X("div",{class:"buttons"},De("Save",()=>r("here"),{class:"main",id:"save-here"}),De("Download",()=>r("download"),{id:"save-download"})));i.addEventListener("keydown",a=>a.key==="Enter"&&r("here")),o.addEventListener("close",()=>{o.remove(),t(s)}),o.showModal(),i.focus(),i.select()})}var l_=32768;function DT(n){let t="";for(let e=0;e<n.length;e+=l_)t+=String.fromCharCode(...n.subarray(e,e+l_));return btoa(t)}var NT=n=>n.some(t=>/\.(urdf|xml|mjcf)$/i.test(t))?"hand":"object",OT=n=>n.some(t=>/\.(toml|urdf|xml|mjcf)$/i.test(t));async function UT(n){let t=Ln("As",()=>{});t.set(["object","obstacle","hand"],NT(n));let e=Ln("Units",()=>{});e.set(["m","cm","mm","in"],"m");let i=!OT(n),s=X("span",{},`Import ${n.length===1?n[0]:`${n.length} files`}`,t,i?e:null);return await Tl(s,"Import")?{as:t.value(),...i?{units:e.value()}:{}}:null}var c_=n=>new Promise((t,e)=>n(t,e));async function h_(n){if(n.isFile)return[{path:n.fullPath.replace(/^\//,""),file:await c_((...i)=>n.file(...i))}];let t=n.createReader(),e=[];for(;;){let i=await c_((...s)=>t.readEntries(...s));if(!i.length)return e;for(let s of i)e.push(...await h_(s))}}var u_=n=>[...n].map(t=>({path:t.webkitRelativePath||t.name,file:t}));async function FT({items:n,files:t}){let e=[...n??[]].map(i=>i.webkitGetAsEntry?.()).filter(Boolean);return e.length?(await Promise.all(e.map(h_))).flat():u_(t)}async function BT(n,t){let e=t.map(({path:o})=>o);if(t.length===1&&/\.toml$/i.test(e[0])){let o=await t[0].file.text();await n.mayLeave()&&await n.ask("world.load",{text:o,name:e[0].replace(/\.toml$/i,"")});return}let i=await UT(e);if(!i)return;let s=await Promise.all(t.map(async({path:o,file:a})=>({name:o,data:DT(new Uint8Array(await a.arrayBuffer()))}))),r=await n.ask("world.import",{files:s,...i});r&&n.notices.tell(`${r.name} was imported.`)}function d_(n){let t=X("input",{type:"file",multiple:!0,hidden:!0,id:"files"});document.body.append(t);let e=s=>s.then(r=>r.length&&BT(n,r)).catch(r=>n.notices.error(r.message));t.addEventListener("change",()=>{e(Promise.resolve(u_(t.files))),t.value=""});let i=s=>document.body.classList.toggle("dropping",s);return addEventListener("dragover",s=>{s.preventDefault(),i(!0)}),addEventListener("dragleave",()=>i(!1)),addEventListener("drop",s=>{s.preventDefault(),i(!1),e(FT(s.dataTransfer))}),()=>t.click()}async function f_(n){let t=n.store.state?.world??{},e=t.file&&!t.file.startsWith("/")?t.file:`${t.name||"world"}.toml`,i=await a_(e);if(i){if(i.where==="download"){let s=await n.ask("world.text");s&&Ci(i.name.split("/").at(-1),s.toml,"application/toml");return}await kT(n,i.name)&&n.notices.tell(`Saved as ${i.name}.`)}}async function kT(n,t,e=i=>Tl(i,"Replace it")){try{return await n.call("world.save",{file:t})}catch(i){return/is there already/.test(i.message)?await e(`${i.message.split(": 'overwrite'")[0]}.`)?n.ask("world.save",{file:t,overwrite:!0}):null:(i.code!=="lost"&&n.notices.error(`world.save: ${i.message}`),null)}}var p_="THF1";function m_(n,t,e){if(n.byteLength!==t)throw new Error(`wanted ${e} of ${t} bytes, got ${n.byteLength}`)}function zT(n){if(n.byteLength<52)throw new Error("a frame has 52 bytes at least");let t=String.fromCharCode(...[0,1,2,3].map(i=>n.getUint8(i)));if(t!==p_)throw new Error(`wanted a frame ${p_}, got ${JSON.stringify(t)}`);let e=i=>n.getUint16(i,!0);return{revision:n.getUint32(4,!0),sequence:n.getUint32(8,!0),time:n.getFloat64(16,!0),counts:{bodies:e(24),joints:e(26),lines:e(28),contacts:e(30),arrows:e(32),points:e(34)},step:1e-6*(e(36)||10),origin:[40,44,48].map(i=>n.getFloat32(i,!0))}}function GT(n,t){let e=s=>[0,4,8].map(r=>n.getFloat32(t+s+r,!0)),i=s=>s===65535?-1:s;return{a:i(n.getUint16(t,!0)),b:i(n.getUint16(t+2,!0)),point:e(4),normal:e(16),force:e(28),friction:n.getFloat32(t+40,!0)}}function g_(n){let t=new DataView(n),{counts:e,step:i,origin:s,...r}=zT(t),o={bodies:28*e.bodies,joints:4*e.joints,tensions:4*e.lines,contacts:44*e.contacts,arrows:24*e.arrows,points:6*e.points};m_(t,52+Object.values(o).reduce((d,h)=>d+h),"a frame");let a=52,l={};for(let[d,h]of Object.entries(o))l[d]=a,a+=h;let c=d=>new Float32Array(n,l[d],o[d]/4),u=new Int16Array(n,l.points,3*e.points);return{...r,bodies:c("bodies"),joints:c("joints"),tensions:c("tensions"),contacts:Array.from({length:e.contacts},(d,h)=>GT(t,l.contacts+44*h)),arrows:c("arrows"),points:Float32Array.from(u,(d,h)=>s[h%3]+i*d)}}var VT=65536;function __(n){let t=new DataView(n);if(t.byteLength<8)throw new Error("a mesh has 8 bytes at least");let[e,i]=[t.getUint32(0,!0),t.getUint32(4,!0)],s=e<=VT?Uint16Array:Uint32Array;m_(t,8+12*e+3*s.BYTES_PER_ELEMENT*i,"a mesh");let r=new s(n,8+12*e,3*i);for(let o=0;o<r.length;++o)if(r[o]>=e)throw new Error(`a triangle names a corner beyond the ${e} of its mesh`);return{positions:new Float32Array(n,8,3*e),triangles:r}}function Qs(n,t=(e,i)=>i){let e=null,i=[];async function s(){for(;i.length>0;){let{value:r,settled:o}=i.shift();await n(r).then(o.resolve,o.reject)}e=null}return r=>{let o=i.at(-1),a=o?t(o.value,r):null;if(a!==null)o.value=a;else{let c={};c.promise=new Promise((u,d)=>Object.assign(c,{resolve:u,reject:d})),i.push({value:r,settled:c})}let{promise:l}=i.at(-1).settled;return e??(e=s()),l}}function eu(n,t,e=setTimeout,i=clearTimeout){let s=null;return()=>{s!==null&&i(s),s=e(()=>{s=null,n()},t)}}var Cl=class extends Error{constructor(t,e){super(t),this.code=e}};function x_(n,t,{openSocket:e=s=>new WebSocket(s),later:i=(s,r)=>setTimeout(s,r)}={}){let s=new Map,r=null,o=1,a=0,l=!1;function c({id:p,result:g,error:m}){let _=s.get(p);if(!_){m&&t.notice("error",m);return}s.delete(p),m?_.reject(new Cl(m.message??"failed",m.code)):_.resolve(g)}function u(p){if(typeof p!="string")return t.frame(p);let g=JSON.parse(p);g.method?t.notice(g.method,g.params??{}):c(g)}function d(){let p=[...s.values()].map(({method:m})=>m);for(let{method:m,reject:_}of s.values())_(new Cl(`the connection was lost before ${m} was answered`,"lost"));if(s.clear(),r=null,l)return;let g=Math.min(4e3,250*2**a++);t.link({connected:!1,wait:g,lost:p}),i(h,g)}function h(){if(l)return;let p=e(n);p.binaryType="arraybuffer",p.onopen=()=>{a=0,r=p,t.link({connected:!0,wait:0,lost:[]})},p.onmessage=({data:g})=>u(g),p.onclose=d}function f(p,g={}){if(!r)return Promise.reject(new Cl("thenar is not connected","not connected"));let m=o++;return new Promise((_,x)=>{s.set(m,{method:p,resolve:_,reject:x}),r.send(JSON.stringify({jsonrpc:"2.0",id:m,method:p,params:g}))})}return h(),{call:f,connected:()=>r!==null,waiting:()=>[...s].map(([p,{method:g}])=>({id:p,method:g})),close:()=>{l=!0,r?.close()}}}function y_(n){let t=[],e={...n};return e.set=i=>{let s=Object.keys(i).filter(r=>e[r]!==i[r]);Object.assign(e,i);for(let{names:r,work:o}of t)r.some(a=>s.includes(a))&&o(e)},e.on=(i,s)=>t.push({names:i,work:s}),e}var v_=(n,t)=>t.revision===n.revision&&t.bodies.length===7*n.bodies.length&&t.joints.length===n.joints.length&&t.tensions.length===n.lines.length&&t.arrows.length===6*n.arrows.length&&t.points.length===3*n.lines.reduce((e,{points:i})=>e+i,0);function Er(n){let t=new Map;return n.bodies.forEach(({owner:e,role:i,movable:s},r)=>{let o=i==="object"||i==="obstacle"?i:"hand";t.has(e)||t.set(e,{name:e,kind:o,movable:s,bodies:[]}),t.get(e).bodies.push(r)}),[...t.values()]}var zf=(n,t)=>n.joints.map((e,i)=>({index:i,...e})).filter(e=>t===void 0||e.hand===t);function b_(n,t){return t.led_by?n.joints.find(e=>e.hand===t.hand&&e.name===t.led_by)??t:t}function S_(n,t){let{owner:e,digit:i}=n.bodies[t];for(let s=t;s>=0;--s){let r=n.bodies[s];if(r.owner!==e||r.digit!==i)break;let o=n.joints.findLastIndex(a=>a.body===s&&!a.led_by);if(o>=0)return o}return-1}function Gf(n,t,e,i){let s={[t.name]:e};return n==="world"?{method:"hand.set_joints",params:{hand:t.hand,joints:s,gesture:i}}:n==="tendons"?{method:"tendons.set",params:{posture:s}}:n==="motion"?{method:"motion.set",params:{targets:s}}:null}var w_=(n,t)=>n.hand===t.hand&&n.name===t.name&&n.gesture===t.gesture,M_=(n,t)=>w_(n,t)?t:null;function nu(n,t){if(n.method!==t.method||!w_(n.params,t.params))return null;let e={...t.params};for(let i of["joints","posture","targets","tensions","excitations"])(n.params[i]||t.params[i])&&(e[i]={...n.params[i],...t.params[i]});return{method:t.method,params:e}}var Rl=["#4c02a1","#7e03a8","#a82296","#cb4679","#e56b5d","#f89441","#fdc328"],E_=n=>[1,3,5].map(t=>parseInt(n.slice(t,t+2),16));function WT(n){let t=Math.min(1,Math.max(0,n))*(Rl.length-1),e=Math.min(Math.floor(t),Rl.length-2),[i,s]=[E_(Rl[e]),E_(Rl[e+1])];return`#${i.map((o,a)=>Math.round(o+(t-e)*(s[a]-o))).map(o=>o.toString(16).padStart(2,"0")).join("")}`}var A_=(n,{low:t,high:e})=>WT(e>t?(n-t)/(e-t):0),T_=()=>`linear-gradient(to right, ${Rl.join(", ")})`;function C_(){let n=X("span",{class:"number"},"0"),t=X("span",{class:"number"}),e=X("span",{class:"ramp"});e.style.background=T_();let i=X("div",{class:"color-bar",hidden:!0},X("span",{},"tension [N]"),n,e,t,X("span",{class:"dashed"},"slack")),s=X("div",{class:"force-scale",hidden:!0}),r=X("div",{class:"moment-scale",hidden:!0}),o=X("div",{class:"key-box","aria-label":"Legend",role:"group"},i,s,r),a="",l=null;return o.measure=()=>{let{left:c,right:u,top:d,bottom:h}=o.getBoundingClientRect();l=u>c&&h>d?{left:c,right:u,top:d,bottom:h}:null},o.box=()=>l,new ResizeObserver(o.measure).observe(o),o.show=({tensionEnd:c,forceScale:u,momentRadius:d=null})=>{let h=`${c} ${u} ${d}`;h!==a&&(a=h,i.hidden=c===null,s.hidden=u===null,r.hidden=d===null,c!==null&&(t.textContent=he(c)),u!==null&&(s.textContent=`arrows: 10\u202Fmm for ${he(.01/u)}\u202FN`),d!==null&&(r.textContent=`disturbance: moment over the object's radius, ${he(1e3*d,1)}\u202Fmm`))},o}var XT=12e3,$T=4,qT=250;function R_(n,t){let e=X("div",{class:"notes"}),i=X("div",{class:"lost",role:"alert",hidden:!0}),s=X("div",{class:"hidden-words",role:"status","aria-live":"polite"}),r=X("progress",{max:1}),o=X("span",{class:"words"}),a=X("div",{class:"work",role:"group","aria-label":"Progress",hidden:!0},o,r,De("Stop",t,{class:"stop"}));n.append(i,a,e,s);function l(h,f){for([...e.children].find(m=>m.dataset.text===h)?.remove();e.children.length>=$T;)e.firstElementChild.remove();let g=X("div",{class:`note-box ${f}`,role:f==="error"?"alert":"status"},X("p",{},h));g.dataset.text=h,g.append(De("\xD7",()=>g.remove(),{"aria-label":"Close this note"})),e.append(g),f!=="error"&&setTimeout(()=>g.remove(),XT)}let c=null,u=({text:h,fraction:f})=>{o.textContent=h,Number.isFinite(f)?r.value=f:r.removeAttribute("value")};return{error:h=>l(h,"error"),tell:h=>l(h,"told"),say:h=>s.textContent=h,progress:u,busy:h=>{if(!h){clearTimeout(c),c=null,a.hidden=!0;return}c===null&&(u({text:h}),c=setTimeout(()=>a.hidden=!1,qT))},link:({connected:h,wait:f,lost:p=[]})=>{i.hidden=h;let g=p.length?` No answer came to ${p.join(", ")}.`:"";i.textContent=h?"":`The connection to thenar is lost; trying again in ${(f/1e3).toFixed(1)}\u202Fs.${g}`}}}var YT=({name:n,body:t},e)=>n.split(/[/.]/).slice(0,-1).join(" ")||e[t]?.digit||"",ZT=({name:n})=>n.split("/").at(-1);function jT(n,t){let e=t.map(r=>{let o=xs({name:ZT(r),title:r.name,lower:r.lower,upper:r.upper,quantity:Zs(r),note:r.led_by?`goes with ${r.led_by}`:null,off:!!r.led_by||!n.canMove(r)},a=>n.moveJoint(r,a));return o.dataset.joint=r.name,o.addEventListener("focusin",()=>{r.led_by||n.select({owner:r.hand,joint:r.name},{quiet:!0})}),{joint:r,row:o}}),i=new Map;for(let{joint:r,row:o}of e){let a=YT(r,n.store.scene.bodies);i.has(a)||i.set(a,[]),i.get(a).push(o)}let s=[...i].map(([r,o])=>r?We(r,...o):X("div",{},...o));return{rows:e,elements:s}}function P_(n){let{store:t}=n,e=Ln("Hand",h=>n.select({owner:h})),i=X("div",{}),s=X("p",{class:"where","aria-live":"off"}),r=X("div",{class:"page pose"},e,s,i),o=[],a=()=>{let h=[...new Set(t.scene?.joints.map(p=>p.hand)??[])],f=t.selected?.owner;return h.includes(f)?f:h.includes(e.value())?e.value():h[0]},l=()=>{let h=[...new Set(t.scene?.joints.map(_=>_.hand)??[])];e.hidden=h.length<2;let f=a();e.set(h,f);let p=JSON.stringify([f,t.scene?.mode,t.scene&&zf(t.scene,f)]);if(r.dataset.key===p)return;r.dataset.key=p;let g=jT(n,f===void 0?[]:zf(t.scene,f));o=g.rows;let m=X("p",{class:"hint"},"There are no joints. Add a hand to pose it.");i.replaceChildren(...o.length?g.elements:[m]),c()},c=()=>{if(!(!t.frame||r.hidden))for(let{joint:h,row:f}of o)f.set(t.frame.joints[h.index])},u=()=>{for(let{joint:h,row:f}of o)f.mark(t.selected?.joint===h.name&&t.selected.owner===h.hand);l(),d()},d=()=>{let h=n.poseOf(t.selected?.owner);s.hidden=!h,h&&(s.textContent=`${t.selected.owner} stands at ${h.map(f=>(f*1e3).toFixed(1)).join(", ")} mm`)};return t.on(["scene"],l),t.on(["frame","tab"],()=>{c(),d()}),t.on(["selected"],u),l(),r}var I_=(n,t,e)=>`${t.name} ${aa(e,Zs(t))}${b_(n,t)===t?"":" (led)"}`;var L_={width:110,height:36};function D_({width:n,height:t,insets:e},i=null){let[s,r]=[n-e.right,t-e.bottom];return[{left:0,right:e.left,top:0,bottom:t},{left:s,right:n,top:0,bottom:t},{left:0,right:n,top:0,bottom:e.top},{left:0,right:n,top:r,bottom:t},{left:e.left,right:e.left+84,top:r-84,bottom:r},{left:s-L_.width,right:s,top:r-L_.height,bottom:r},...i?[i]:[]]}function iu(n,t=Math.PI/3){let e=n.index?n.toNonIndexed():n,i=e.attributes.position,s=i.count,r;if(i.isBufferAttribute===!0&&i.itemSize===3&&i.normalized===!1)r=i.array;else{r=new Float64Array(s*3);for(let y=0;y<s;y++)r[3*y+0]=i.getX(y),r[3*y+1]=i.getY(y),r[3*y+2]=i.getZ(y)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let y=0;y<l;y++){let C=9*y,A=r[C+0],v=r[C+1],M=r[C+2],U=r[C+3],P=r[C+4],L=r[C+5],F=r[C+6],G=r[C+7],N=r[C+8],z=F-U,Y=G-P,V=N-L,ot=A-U,$=v-P,K=M-L,et=Y*K-V*$,ht=V*ot-z*K,ut=z*$-Y*ot,Q=1/(Math.sqrt(et*et+ht*ht+ut*ut)||1);c[3*y+0]=et*Q,c[3*y+1]=ht*Q,c[3*y+2]=ut*Q}let u=new Int32Array(s),d=new Float64Array(s*3),h=1;for(;h<s*2;)h<<=1;let f=h-1,p=new Int32Array(h),g=0;for(let y=0;y<s;y++){let C=3*y,A=Math.trunc(r[C+0]*a),v=Math.trunc(r[C+1]*a),M=Math.trunc(r[C+2]*a),U=(Math.imul(A,73856093)^Math.imul(v,19349663)^Math.imul(M,83492791))&f;for(;;){let P=p[U];if(P===0){let F=3*g;d[F+0]=A,d[F+1]=v,d[F+2]=M,p[U]=g+1,u[y]=g++;break}let L=3*(P-1);if(d[L+0]===A&&d[L+1]===v&&d[L+2]===M){u[y]=P-1;break}U=U+1&f}}let m=new Int32Array(g+1);for(let y=0;y<s;y++)m[u[y]+1]++;for(let y=0;y<g;y++)m[y+1]+=m[y];let _=new Int32Array(s),x=m.slice(0,g);for(let y=0;y<l;y++){let C=3*y;_[x[u[C+0]]++]=y,_[x[u[C+1]]++]=y,_[x[u[C+2]]++]=y}let S=new Float32Array(s*3);for(let y=0;y<l;y++){let C=3*y,A=c[C+0],v=c[C+1],M=c[C+2];for(let U=0;U<3;U++){let P=C+U,L=u[P],F=0,G=0,N=0;for(let Y=m[L],V=m[L+1];Y<V;Y++){let ot=3*_[Y],$=c[ot+0],K=c[ot+1],et=c[ot+2];A*$+v*K+M*et>o&&(F+=$,G+=K,N+=et)}let z=1/(Math.sqrt(F*F+G*G+N*N)||1);S[3*P+0]=F*z,S[3*P+1]=G*z,S[3*P+2]=N*z}}return e.setAttribute("normal",new Ze(S,3,!1)),e}var JT=600,KT=2.2,N_=1<<20;function QT(n,t){let e=0;for(let i=0;i<t.length;i+=3){let[s,r]=[3*t[i],3*t[i+1]],o=n[s]-n[r],a=n[s+1]-n[r+1],l=n[s+2]-n[r+2];e+=Math.sqrt(o*o+a*a+l*l)}return e/Math.max(1,t.length/3)}function tC(n,t){let e=n.length/3,i=new Int32Array(n.length);for(let a=0;a<n.length;++a)i[a]=(Math.floor(n[a]/t)+N_/2)%N_;let s=2**Math.ceil(Math.log2(2*e+1)),r=new Int32Array(s).fill(-1),o=new Uint32Array(e);for(let a=0;a<e;++a){let[l,c,u]=[i[3*a],i[3*a+1],i[3*a+2]],d=Math.imul(l,73856093)^Math.imul(c,19349663)^Math.imul(u,83492791),h=(d^d>>>15)&s-1,f=r[h];for(;f>=0&&(i[3*f]!==l||i[3*f+1]!==c||i[3*f+2]!==u);)h=h+1&s-1,f=r[h];f<0&&(r[h]=f=a),o[a]=f}return o}function eC(n,t,e){let i=tC(n,e),s=[];for(let r=0;r<t.length;r+=3){let o=i[t[r]],a=i[t[r+1]],l=i[t[r+2]];o!==a&&a!==l&&l!==o&&s.push(o,a,l)}return Uint32Array.from(s)}function O_(n){let{index:t,attributes:e}=n;if(!t||t.count<3*JT)return n;let i=e.position.array,s=KT*QT(i,t.array),r=new we;for(let[o,a]of Object.entries(e))r.setAttribute(o,a);return r.setIndex(new Ze(eC(i,t.array,s),1)),r.boundingBox=n.boundingBox,r.boundingSphere=n.boundingSphere,n.addEventListener("dispose",()=>r.dispose()),r}var nC="#dfab8f",iC="#f0d3c6",sC="#e6dcc3",rC="#7d8794",oC="#e6a83c",aC="#b9c0c9",U_=["#6fa8cf","#8dbb95","#c7a6d1","#d3a15f","#7cc0c4","#b0a37a"],lC=3813392,cC=({role:n,material:t})=>n==="link"&&(t==="skin"||t==="fingertip");function hC(n){let t=new Map;return n.map(({owner:e,digit:i})=>{if(!i)return rC;t.has(e)||t.set(e,[]);let s=t.get(e);return s.includes(i)||s.push(i),U_[s.indexOf(i)%U_.length]})}function uC(n,t){return cC(n)?nC:n.role==="nail"?iC:n.role==="bone"||n.material==="bone"?sC:n.role==="object"?oC:n.role==="obstacle"?aC:t}var dC=(n,t)=>n.lines.length>0||n.bodies.some(e=>e.owner===t&&e.role==="bone"),fC=(n,t)=>t.role==="object"?"objects":(t.role==="link"||t.role==="nail")&&dC(n,t.owner)?"hands":null,pC=(n,t)=>n.role==="nail"?0:{hands:1,objects:2}[t]??0;function F_(n){let t=hC(n.bodies);return n.bodies.map((e,i)=>{let s=fC(n,e);return{color:uC(e,t[i]),layer:s,once:pC(e,s)}})}var B_=n=>new Jn({color:n,stencilFunc:sf,stencilZPass:nf});function su(n,t,e=0){let{material:i,userData:s}=n,r=i.opacity<1;s.veil&&(s.veil.visible=r&&t),i.depthWrite=!r||!t,i.stencilWrite=r&&!t&&s.once>0,i.stencilRef=s.once,n.renderOrder=r?3+e:0}function Vf(n,t){let{material:e}=n;e.transparent=t<1,e.opacity=t,e.needsUpdate=!0,n.castShadow=t>.2,su(n,!0)}var k_=(n,t)=>n.material.emissive.setHex(t?lC:0);function mC(n,t){let e=new Float32Array(n.length);for(let i=0;i<t.length;i+=3){let[s,r,o]=[3*t[i],3*t[i+1],3*t[i+2]],[a,l,c]=[n[r],n[r+1],n[r+2]],[u,d,h]=[n[o]-a,n[o+1]-l,n[o+2]-c],[f,p,g]=[n[s]-a,n[s+1]-l,n[s+2]-c],[m,_,x]=[d*g-h*p,h*f-u*g,u*p-d*f];for(let S of[s,r,o])e[S]+=m,e[S+1]+=_,e[S+2]+=x}for(let i=0;i<e.length;i+=3){let s=Math.hypot(e[i],e[i+1],e[i+2])||1;e[i]/=s,e[i+1]/=s,e[i+2]/=s}return e}function gC(n){let t=[1/0,1/0,1/0],e=[-1/0,-1/0,-1/0];for(let o=0;o<n.length;o+=3)for(let a=0;a<3;++a){let l=n[o+a];l<t[a]&&(t[a]=l),l>e[a]&&(e[a]=l)}let i=new Be(new R(...t),new R(...e)),s=i.getCenter(new R),r=0;for(let o=0;o<n.length;o+=3){let[a,l,c]=[n[o]-s.x,n[o+1]-s.y,n[o+2]-s.z];r=Math.max(r,a*a+l*l+c*c)}return{box:i,ball:new oi(s,Math.sqrt(r))}}function Hf({positions:n,triangles:t}){let e=new we;e.setAttribute("position",new Ze(n,3)),e.setAttribute("normal",new Ze(mC(n,t),3)),e.setIndex(new Ze(t,1));let{box:i,ball:s}=gC(n);return e.boundingBox=i,e.boundingSphere=s,e}function _C(n,t){let e=Hf(n);return t!=null&&t>=0?iu(e,t*Math.PI/180):e}function z_(n){let t=new Map,e=({mesh:r,crease:o})=>`${r} ${o}`;return{get:r=>{let o=e(r);if(!t.has(o)){let a=n(r.mesh).then(l=>_C(__(l),r.crease));a.catch(()=>t.delete(o)),t.set(o,a)}return t.get(o)},keepOnly:r=>{let o=new Set(r.filter(({mesh:a})=>a).map(e));for(let[a,l]of t)o.has(a)||(t.delete(a),l.then(c=>c.dispose()).catch(()=>{}))},size:()=>t.size}}function xC(n){let t=new mt(n,new ai({colorWrite:!1}));return t.renderOrder=2,t.visible=!1,t.raycast=()=>{},t}function G_(n,t,e,i){let s=new mt(t,B_(e.color));return s.castShadow=s.receiveShadow=!0,s.userData={...e,body:i,surface:t,veil:xC(t)},n.add(s,s.userData.veil),n.userData.mesh=s,s}function yC({geometry:n,matrixWorld:t},e){return n.boundingSphere??n.computeBoundingSphere(),n.boundingSphere.center.clone().applyMatrix4(t).dot(e)}function vC(n){for(let t of n.groups)t.userData.mesh?.material.dispose(),t.userData.mesh?.userData.veil.material.dispose(),t.removeFromParent()}function bC(n,t,e){var o;for(let a of n){let{surface:l}=a.userData;a.geometry=t?l:(o=l.userData).coarse??(o.coarse=O_(l))}let i=n.filter(({material:a})=>a.opacity<1);if(t)return i.forEach(a=>su(a,!0));let s=e.getWorldDirection(new R),r=new Map(i.map(a=>[a,yC(a,s)]));i.sort((a,l)=>r.get(a)-r.get(l)),i.forEach((a,l)=>su(a,!1,l/i.length))}var SC=(n,{groups:t,hidden:e})=>n.bodies.map(({name:i,owner:s},r)=>{let o=new Ee;o.name=i,o.visible=!e.has(s);let a=t.find(l=>l.name===i);return a&&o.position.copy(a.position),a&&o.quaternion.copy(a.quaternion),o.userData.index=r,o});function wC(n,t){let e={object:new Be,obstacle:new Be};for(let i of t){let{geometry:s,parent:r,userData:o}=i;s.boundingBox??s.computeBoundingBox(),r.updateMatrixWorld();let{role:a}=n.bodies[o.body];e[a==="obstacle"?a:"object"].union(s.boundingBox.clone().applyMatrix4(r.matrixWorld))}return e.object.isEmpty()?e.obstacle:e.object}function MC(){let n=new Ee,t=Hf({positions:new Float32Array(9),triangles:new Uint16Array([0,1,2])});for(let e of[1,.5])Vf(G_(n,t,{},-1),e);return n}function V_(n,t,e){let i={groups:[],hidden:new Set,opacities:{hands:.5,objects:1}};i.samples=MC();let s=null,r=null,o=l=>{let{layer:c}=l.userData;Vf(l,c?i.opacities[c]:1),k_(l,s.bodies[l.userData.body].owner===r)},a=()=>i.groups.flatMap(({userData:l})=>l.mesh??[]);return i.show=l=>{let c=SC(l,i);vC(i),s=l,i.groups=c;for(let d of c)n.add(d);let u=F_(s);return t.keepOnly(s.bodies),Promise.all(s.bodies.map(async(d,h)=>{if(!d.mesh)return;let f=await t.get(d);s===l&&(o(G_(c[h],f,u[h],h)),e())}))},i.pose=({bodies:l})=>i.groups.forEach((c,u)=>{let d=7*u;c.position.set(l[d],l[d+1],l[d+2]);let[h,f,p,g]=[3,4,5,6].map(m=>l[d+m]);c.quaternion.set(f,p,g,h),c.updateMatrixWorld()}),i.hide=(l,c)=>{c?i.hidden.add(l):i.hidden.delete(l),i.groups.forEach((u,d)=>{u.visible=!i.hidden.has(s.bodies[d].owner)})},i.select=l=>{r=l,a().forEach(o)},i.opacity=(l,c)=>{i.opacities[l]=c,a().forEach(o)},i.prepare=(l,c)=>bC(a(),l,c),i.meshes=()=>a().filter(l=>l.parent.visible),i.box=()=>wC(s,a()),i}var H_=["#0072b2","#d55e00","#cc79a7","#e69f00","#56b4e9"];function EC(n){let t=Uint8Array.from(atob(n),e=>e.charCodeAt(0));if(t.length%24)throw new Error(`wanted 24 bytes a segment of a cloud, got ${t.length}`);return new Float32Array(t.buffer)}function W_(n){let t=[];return{show:(i,s)=>{for(let r of t)r.geometry.dispose(),r.material.dispose(),r.removeFromParent();t=i.clouds.map(({name:r,body:o,segments:a},l)=>{let c=new we;c.setAttribute("position",new Ze(EC(a),3));let d={color:H_[l%H_.length],transparent:!0,opacity:.22,depthWrite:!1},h=new Vs(c,new Bi(d));return h.name=r,h.renderOrder=1,h.raycast=()=>{},(s[o]??n).add(h),h})}}}function Ar(n){let t=10**Math.floor(Math.log10(n));return[1,2,5,10].find(i=>i*t>=n*(1-1e-9))*t}var AC=1e-12;function X_(n,t=0,e=AC){let i=n.filter(Number.isFinite);if(i.length===0)return[0,1];let s=i.reduce((l,c)=>Math.min(l,c)),r=i.reduce((l,c)=>Math.max(l,c)),o=Math.max(Math.abs(s),Math.abs(r)),a=r-s>e*o?t*(r-s):.5*(o||1);return[s-a,r+a]}var TC=new R(0,1,0),$_="#b3261e",q_="#d55e00",CC={force:q_,moment:"#993366",axis:"#777777",measured:"#0072b2",predicted:"#d55e00",disturbance:"#cc79a7"},RC={force:.0045,moment:.0045,axis:.0022,measured:.006,predicted:.0035,disturbance:.0045},PC=.3,ru=6,IC=.01,Wf=1e-6,LC=.05,Y_=(n=[])=>Wf*n.reduce((t,e)=>e>t?e:t,1);function Z_(n,t,e,i=0){if(!(n>i))return e??null;let s=PC*t/n;return e&&e<=s*1.001&&e>.2*s?e:1/Ar(1/s)}function ou(n,t,e,i=4){let s=null,r=o=>(s&&s.instanceMatrix.count>=o||(s?.removeFromParent(),s?.dispose(),s=new Gs(t,e,Math.max(16,2*o)),s.instanceMatrix.setUsage(cf),s.frustumCulled=!1,s.raycast=()=>{},s.renderOrder=i,n.add(s)),s);return o=>{let a=r(o.length);o.forEach((l,c)=>a.setMatrixAt(c,l)),a.count=o.length,a.visible=o.length>0,a.instanceMatrix.needsUpdate=!0}}function Xf(n,t,e){let i=t.clone().sub(n),s=i.length(),r=new Ie().setFromUnitVectors(TC,i.divideScalar(s||1)),o=n.clone().add(t).multiplyScalar(.5);return new Kt().compose(o,r,new R(e,s,e))}function j_(n,t,e=ru){let i={depthTest:!1,transparent:!0},s=new Jn({...i,color:t,emissive:t,emissiveIntensity:.25}),r=ou(n,new Ve(1,1,1,10),s,e),o=ou(n,new ki(1,1,14),s,e);return(a,l)=>{let c=a.filter(({vector:u})=>u.lengthSq()>0).map(({from:u,vector:d})=>{let h=u.clone().add(d),f=Math.min(7*l,.5*d.length()),p=h.clone().addScaledVector(d.clone().normalize(),-f);return[Xf(u,p,l),Xf(p,h,2.6*l)]});r(c.map(([u])=>u)),o(c.map(([,u])=>u))}}function DC({point:n,normal:t,friction:e},i){let s=new R(...n),r=s.clone().addScaledVector(new R(...t),i);return Xf(r,s,Math.min(e,2)*i)}function J_(n){let t=new Ee,e=new Ee;n.add(t),t.add(e);let i=new ai({color:$_,depthTest:!1,transparent:!0}),s=ou(t,new di(1,12,8),i,ru),r=new Jn({color:$_,transparent:!0,opacity:.3,side:an,depthWrite:!1}),o=ou(e,new ki(1,1,24,1,!0),r),a=j_(t,q_),l={contacts:!0,cones:!0,forces:!0},c=null;return{pose:({contacts:d},h)=>{let f=l.contacts?d:[],p=.006*h;s(f.map(({point:x})=>new Kt().makeTranslation(...x).scale(new R(p,p,p)))),o(l.cones?f.filter(x=>x.friction>0).map(x=>DC(x,LC*h)):[]);let g=Math.max(0,...d.map(({force:x})=>Math.hypot(...x))),m=Y_();c=Z_(g,h,c,m);let _=l.forces&&c?d:[];return a(_.map(({point:x,force:S})=>({from:new R(...x),vector:new R(...S).multiplyScalar(c)})),.004*h),{forceScale:g>m?c:null}},show:l,forget:()=>c=null}}var NC=({kind:n,name:t})=>{let e=n==="moment"||/moment/i.test(t);return n==="disturbance"?e?"disturbance moment":"disturbance":e?"moment":n==="axis"?"axis":"force"};function OC(n,t){let e=t?n.filter(({unit:i})=>i==="disturbance moment"):[];for(let i of e)i.vector.divideScalar(t),i.unit="disturbance";return e}function UC(n,t){let e=Y_(n),[i,s]=[e*t,Wf];return{force:e,moment:i,disturbance:s,"disturbance moment":Wf*t}}function K_(n){let t=new Ee;n.add(t);let e=Object.fromEntries(Object.entries(CC).map(([c,u])=>[c,j_(t,u,c==="predicted"?ru+.5:ru)])),i=[],s={},r=null,o=!1;return{show:c=>{i=c.arrows.map(u=>({kind:u.kind,unit:NC(u)})),s={},r=null},pose:({arrows:c,tensions:u},d)=>{let h=i.map(({kind:g,unit:m},_)=>({kind:g,unit:m,from:new R(...c.subarray(6*_,6*_+3)),vector:new R(...c.subarray(6*_+3,6*_+6))})),f=OC(h,r),p=UC(u,d);for(let g of Object.keys(p)){let m=Math.max(0,...h.filter(_=>_.unit===g).map(_=>_.vector.length()));s[g]=Z_(m,d,s[g],p[g])}for(let{unit:g,vector:m}of h)g==="axis"?m.setLength(m.length()>0?.12*d:0):m.multiplyScalar(m.length()>p[g]?s[g]??0:0);o=f.some(({vector:g})=>g.lengthSq()>0);for(let[g,m]of Object.entries(e))m(h.filter(_=>_.kind===g),RC[g]*d);return t.visible?h.map(({from:g,vector:m},_)=>({position:g.clone().add(m),long:m.length(),i:_})).filter(({long:g})=>g>IC*d):[]},visible:c=>t.visible=c,radius:c=>r=c,momentRadius:()=>o?r:null}}var es=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Pl=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],$f=(n,t,e)=>[n[0]+e*t[0],n[1]+e*t[1],n[2]+e*t[2]],qf=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],au=n=>{let t=Math.hypot(...n);return t>0?n.map(e=>e/t):[0,0,0]};function ex(n,t){let e=au(n),i=$f(t,e,-es(t,e));return Math.hypot(...i)>1e-6*(1+Math.hypot(...t))?au(i):au(qf(e,Math.abs(e[0])<.9?[1,0,0]:[0,1,0]))}var FC=.12;function Q_({axis:n,point:t},{from:e,way:i}){let s=es(n,i);if(Math.abs(s)<FC)return null;let r=es(Pl(t,e),n)/s;return Pl($f(e,i,r),t)}var BC=(n,t,e)=>Math.atan2(es(qf(n,t),e),es(n,t));function nx(n,t,e){if(n.slides)return kC(n,t);let i=Q_(n,t),s=0;return i?r=>{let o=Q_(n,r);return o&&(s+=BC(i,o,n.axis),i=o),s}:zC(n,t,e)}function tx({axis:n,point:t},{from:e,way:i}){let s=Pl(e,t),r=es(n,i),o=1-r*r;return o<1e-6?null:(es(s,n)-r*es(s,i))/o}function kC(n,t){let e=tx(n,t)??0,i=e;return s=>(i=tx(n,s)??i,i-e)}function zC({axis:n,point:t},e,i){let s=au(qf(n,e.way)),r=({from:a,way:l})=>{let c=es(Pl(t,a),e.way)/(es(l,e.way)||1);return es(Pl($f(a,l,c),t),s)},o=r(e);return a=>-(r(a)-o)/i}var GC=84,Tr={range:"#0072b2",end:"#d55e00",needle:"#e69f00"},ix=2*Math.PI,Cr=(n,t=1)=>new ai({color:n,opacity:t,transparent:!0,depthTest:!1,depthWrite:!1,side:an});function Rr(n,t,e=10){let i=new mt(n,t);return i.renderOrder=e,i}function sx(n){let t=Rr(new je(.3,.05,.02),Cr(Tr.end),12);return t.position.set(.95*Math.cos(n),.95*Math.sin(n),0),t.rotation.z=n,t}function VC({lower:n,upper:t}){let e=new Ee,i=new Ee,s=Math.min(ix,t-n);i.add(Rr(new Xr(.82,1,64,1,n,s),Cr(Tr.range,.55))),i.add(Rr(new Xr(0,.82,64,1,n,s),Cr(Tr.range,.12))),s<ix&&i.add(sx(n),sx(t)),e.add(Rr(new Xr(.9,.92,64),Cr(Tr.range,.5)));let r=Rr(new je(1.1,.06,.02),Cr(Tr.needle),13);r.position.x=.55;let o=new mt(new Ai(.91,.16,8,48));return o.visible=!1,e.add(i,r,o),{group:e,grip:o,turn:a=>i.rotation.z=-a}}function HC({lower:n,upper:t}){let e=new Ee,i=new Ee,s=Rr(new je(.08,.08,1),Cr(Tr.range,.55));i.add(s);let r=[1,-1].map(c=>{let u=Rr(new ki(.16,.36,16),Cr(Tr.needle),13);return u.rotation.x=c*Math.PI/2,u.position.z=.9*c,u}),o=Rr(new Ve(.04,.04,1.6,8),Cr(Tr.needle),13);o.rotation.x=Math.PI/2;let a=new mt(new Ve(.22,.22,2.2,8).rotateX(Math.PI/2));return a.visible=!1,e.add(i,o,...r,a),{group:e,grip:a,turn:(c,u)=>{s.scale.z=(t-n)/u,s.position.z=((t+n)/2-c)/u}}}function rx(n,t){let e=new R(...n.axis).normalize(),i=t.userData.mesh,r=(i?i.geometry.boundingSphere.center.toArray():[0,0,0]).map((l,c)=>l-n.point[c]),o=new R(...ex(n.axis,r)),a=new Kt().makeBasis(o,new R().crossVectors(e,o),e);return a.setPosition(...n.point),a.premultiply(t.matrixWorld)}function ox(n,t){let e=null;function i(){if(!e)return;let{joint:c,body:u,shape:d}=e;u.userData.mesh&&(u.userData.mesh.geometry.boundingSphere??u.userData.mesh.geometry.computeBoundingSphere());let{camera:h,width:f}=n;e.radius=GC*(h.right-h.left)/(f*h.zoom);let p=new R,g=new Ie;rx(c,u).decompose(p,g,new R),d.group.position.copy(p),d.group.quaternion.copy(g),d.group.scale.setScalar(e.radius),d.turn(e.value,e.radius),d.group.updateMatrixWorld()}n.preparing.push(i);function s(c,u,d){e&&e.shape.group.removeFromParent(),e=c?{joint:c,body:u,value:d,shape:c.slides?HC(c):VC(c),radius:1}:null,e&&n.scene.add(e.shape.group),e&&i(),n.draw()}let r=({ray:c})=>({from:c.origin.toArray(),way:c.direction.toArray()});function o(c){if(!e||c.intersectObject(e.shape.grip).length===0)return null;let{joint:u,body:d,value:h,radius:f}=e,p=rx(u,d),g=new R().setFromMatrixColumn(p,2).normalize().toArray(),m=new R().setFromMatrixPosition(p).toArray(),_=nx({axis:g,point:m,slides:u.slides},r(c),f);return x=>t(u,_s(h+_(r(x)),u.lower,u.upper))}return{show:s,tell:c=>{e&&(e.value=c)},grab:o,rim:c=>(e.joint.slides?new R(0,0,.9+c):new R(.91*Math.cos(c),.91*Math.sin(c),0)).applyMatrix4(e.shape.group.matrixWorld),held:()=>e}}It.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Wt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ci.line={uniforms:xl.merge([It.common,It.fog,It.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var vs=class extends zi{constructor(t){super({type:"LineMaterial",uniforms:xl.clone(ci.line.uniforms),vertexShader:ci.line.vertexShader,fragmentShader:ci.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var ax=new Be,lu=new R,Pr=class extends al{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new ie(t,3)),this.setAttribute("uv",new ie(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,i=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),i.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new yr(e,6,1);return this.setAttribute("instanceStart",new Fi(i,3,0)),this.setAttribute("instanceEnd",new Fi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new yr(e,6,1);return this.setAttribute("instanceColorStart",new Fi(i,3,0)),this.setAttribute("instanceColorEnd",new Fi(i,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new el(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Be);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),ax.setFromBufferAttribute(e),this.boundingBox.union(ax))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new oi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)lu.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(lu)),lu.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(lu));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Yf=new Le,lx=new R,cx=new R,Wn=new Le,Xn=new Le,bs=new Le,Zf=new R,jf=new Kt,$n=new ll,hx=new R,cu=new Be,hu=new oi,Ss=new Le,ws,Qr;function ux(n,t,e){return Ss.set(0,0,-t,1).applyMatrix4(n.projectionMatrix),Ss.multiplyScalar(1/Ss.w),Ss.x=Qr/e.width,Ss.y=Qr/e.height,Ss.applyMatrix4(n.projectionMatrixInverse),Ss.multiplyScalar(1/Ss.w),Math.abs(Math.max(Ss.x,Ss.y))}function WC(n,t){let e=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){$n.start.fromBufferAttribute(s,a),$n.end.fromBufferAttribute(r,a),$n.applyMatrix4(e);let c=new R,u=new R;ws.distanceSqToSegment($n.start,$n.end,u,c),u.distanceTo(c)<Qr*.5&&t.push({point:u,pointOnLine:c,distance:ws.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function XC(n,t,e){let i=t.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),d=-t.near;ws.at(1,bs),bs.w=1,bs.applyMatrix4(t.matrixWorldInverse),bs.applyMatrix4(i),bs.multiplyScalar(1/bs.w),bs.x*=r.x/2,bs.y*=r.y/2,bs.z=0,Zf.copy(bs),jf.multiplyMatrices(t.matrixWorldInverse,o);for(let h=0,f=u;h<f;h++){if(Wn.fromBufferAttribute(l,h),Xn.fromBufferAttribute(c,h),Wn.w=1,Xn.w=1,Wn.applyMatrix4(jf),Xn.applyMatrix4(jf),Wn.z>d&&Xn.z>d)continue;if(Wn.z>d){let S=Wn.z-Xn.z,y=(Wn.z-d)/S;Wn.lerp(Xn,y)}else if(Xn.z>d){let S=Xn.z-Wn.z,y=(Xn.z-d)/S;Xn.lerp(Wn,y)}Wn.applyMatrix4(i),Xn.applyMatrix4(i),Wn.multiplyScalar(1/Wn.w),Xn.multiplyScalar(1/Xn.w),Wn.x*=r.x/2,Wn.y*=r.y/2,Xn.x*=r.x/2,Xn.y*=r.y/2,$n.start.copy(Wn),$n.start.z=0,$n.end.copy(Xn),$n.end.z=0;let g=$n.closestPointToPointParameter(Zf,!0);$n.at(g,hx);let m=ea.lerp(Wn.z,Xn.z,g),_=m>=-1&&m<=1,x=Zf.distanceTo(hx)<Qr*.5;if(_&&x){$n.start.fromBufferAttribute(l,h),$n.end.fromBufferAttribute(c,h),$n.start.applyMatrix4(o),$n.end.applyMatrix4(o);let S=new R,y=new R;ws.distanceSqToSegment($n.start,$n.end,y,S),e.push({point:y,pointOnLine:S,distance:ws.origin.distanceTo(y),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var ca=class extends mt{constructor(t=new Pr,e=new vs({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,i=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)lx.fromBufferAttribute(e,o),cx.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+lx.distanceTo(cx);let r=new yr(s,2,1);return t.setAttribute("instanceDistanceStart",new Fi(r,1,0)),t.setAttribute("instanceDistanceEnd",new Fi(r,1,1)),this}raycast(t,e){let i=this.material.worldUnits,s=t.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;ws=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Qr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),hu.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Qr*.5;else{let d=Math.max(s.near,hu.distanceToPoint(ws.origin));c=ux(s,d,l.resolution)}if(hu.radius+=c,ws.intersectsSphere(hu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),cu.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=Qr*.5;else{let d=Math.max(s.near,cu.distanceToPoint(ws.origin));u=ux(s,d,l.resolution)}cu.expandByScalar(u),ws.intersectsBox(cu)!==!1&&(i?WC(this,e):XC(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(Yf),this.material.uniforms.resolution.value.set(Yf.z,Yf.w))}};var dx=1,$C=new Zt("#8a8f99"),Jf={taut:{linewidth:3.2},slack:{linewidth:2.2,dashed:!0,dashSize:.003,gapSize:.002},unknown:{linewidth:1.3}},qC=n=>Number.isNaN(n)?"unknown":n>0?"taut":"slack";function YC(n){let t=n.reduce((e,i)=>i>e?i:e,0);return t>dx?Ar(t):dx}function ZC(n,t){let e=new Pr;e.setPositions(new Float32Array(6*t)),e.setColors(new Float32Array(6*t));let i=new ca(e,new vs({...Jf[n],vertexColors:!0}));return i.computeLineDistances(),i.frustumCulled=!1,i.renderOrder=1,i.raycast=()=>{},i}function jC(n,t,e,i,s,r){let{instanceStart:o,instanceColorStart:a,instanceDistanceStart:l}=n.geometry.attributes,c=o.data.array;c.set(e,6*t),c.set(i,6*t+3);let u=a.data.array;s.toArray(u,6*t),s.toArray(u,6*t+3);let d=l.data.array,h=Math.hypot(i[0]-e[0],i[1]-e[1],i[2]-e[2]);return d[2*t]=r,d[2*t+1]=r+h,r+h}function JC(n,t){let{instanceStart:e,instanceColorStart:i,instanceDistanceStart:s}=n.geometry.attributes;n.geometry.instanceCount=t,n.visible=t>0;for(let{data:r}of[e,i,s])r.needsUpdate=!0}function fx(n){let t=new Ee;n.add(t);let e=[],i={};return{show:a=>{e=a.lines;for(let c of Object.values(i))c.geometry.dispose(),c.material.dispose();t.clear();let l=e.reduce((c,{points:u})=>c+Math.max(0,u-1),0);i=l?Object.fromEntries(Object.keys(Jf).map(c=>[c,ZC(c,l)])):{};for(let c of Object.values(i))t.add(c)},pose:({tensions:a,points:l})=>{if(!Object.keys(i).length)return null;let c=YC(a),u={taut:0,slack:0,unknown:0},d=new Zt,h=0;e.forEach((f,p)=>{let g=qC(a[p]);g==="taut"?d.set(A_(a[p],{low:0,high:c})):d.copy($C);let m=0;for(let _=h;_<h+f.points-1;++_){let[x,S]=[l.subarray(3*_,3*_+3),l.subarray(3*_+3,3*_+6)];m=jC(i[g],u[g]++,x,S,d,m)}h+=f.points});for(let[f,p]of Object.entries(u))JC(i[f],p);return u.taut+u.slack>0?c:null},sharpen:a=>Object.entries(i).forEach(([l,{material:c}])=>{c.linewidth=Jf[l].linewidth*a}),visible:a=>t.visible=a,plain:()=>i.unknown}}var KC=new Zt("#0072b2"),QC=new Zt("#e69f00"),tR=6e-4;function px(n,t){let e=null,i=()=>{e&&(e.removeFromParent(),e.geometry.dispose(),e.material.dispose(),e.dispose(),e=null)};return{show:r=>{if(i(),!r.length)return;let o=r.reduce((c,{pressure:u})=>Math.max(c,u),0)||1,a={depthTest:!1,transparent:!0},l=new ai(a);e=new Gs(new di(1,8,6),l,r.length),r.forEach(({point:c,pressure:u,sticks:d},h)=>{let f=tR*(.25+.75*Math.sqrt(Math.max(0,u)/o)),p=new R(f,f,f);e.setMatrixAt(h,new Kt().makeTranslation(...c).scale(p)),e.setColorAt(h,d?KC:QC)}),e.frustumCulled=!1,e.raycast=()=>{},e.renderOrder=7,n.add(e),t()},clear:i}}var to=new Ws,_n=new R,Ir=new R,ln=new Ie,mx={X:new R(1,0,0),Y:new R(0,1,0),Z:new R(0,0,1)},Kf={type:"change"},gx={type:"mouseDown",mode:null},_x={type:"mouseUp",mode:null},xx={type:"objectChange"},mu=class extends qr{constructor(t,e=null){super(void 0,e);let i=new tp(this);this._root=i;let s=new ep;this._gizmo=s,i.add(s);let r=new np;this._plane=r,i.add(r);let o=this;function a(S,y){let C=y;Object.defineProperty(o,S,{get:function(){return C!==void 0?C:y},set:function(A){C!==A&&(C=A,r[S]=A,s[S]=A,o.dispatchEvent({type:S+"-changed",value:A}),o.dispatchEvent(Kf))}}),o[S]=y,r[S]=y,s[S]=y}a("camera",t),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new R,c=new R,u=new Ie,d=new Ie,h=new R,f=new Ie,p=new R,g=new R,m=new R,_=0,x=new R;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",u),a("worldQuaternionStart",d),a("cameraPosition",h),a("cameraQuaternion",f),a("pointStart",p),a("pointEnd",g),a("rotationAxis",m),a("rotationAngle",_),a("eye",x),this._offset=new R,this._startNorm=new R,this._endNorm=new R,this._cameraScale=new R,this._parentPosition=new R,this._parentQuaternion=new Ie,this._parentQuaternionInv=new Ie,this._parentScale=new R,this._worldScaleStart=new R,this._worldQuaternionInv=new Ie,this._worldScale=new R,this._positionStart=new R,this._quaternionStart=new Ie,this._scaleStart=new R,this._getPointer=eR.bind(this),this._onPointerDown=iR.bind(this),this._onPointerHover=nR.bind(this),this._onPointerMove=sR.bind(this),this._onPointerUp=rR.bind(this),e!==null&&this.connect(e)}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(t){if(this.object===void 0||this.dragging===!0)return;t!==null&&to.setFromCamera(t,this.camera);let e=Qf(this._gizmo.picker[this.mode],to);e?this.axis=e.object.name:this.axis=null}pointerDown(t){if(!(this.object===void 0||this.dragging===!0||t!=null&&t.button!==0)&&this.axis!==null){t!==null&&to.setFromCamera(t,this.camera);let e=Qf(this._plane,to,!0);e&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(e.point).sub(this.worldPositionStart)),this.dragging=!0,gx.mode=this.mode,this.dispatchEvent(gx)}}pointerMove(t){let e=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(e==="E"||e==="XYZE"||e==="XYZ")&&(r="world"),s===void 0||e===null||this.dragging===!1||t!==null&&t.button!==-1)return;t!==null&&to.setFromCamera(t,this.camera);let o=Qf(this._plane,to,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&e!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),e.indexOf("X")===-1&&(this._offset.x=0),e.indexOf("Y")===-1&&(this._offset.y=0),e.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&e!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(ln.copy(this._quaternionStart).invert()),e.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(_n),e.search("X")!==-1&&(_n.x=Math.round(_n.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(_n.y=Math.round(_n.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(_n.z=Math.round(_n.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(_n)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(e.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Ir.set(a,a,a)}else _n.copy(this.pointStart),Ir.copy(this.pointEnd),_n.applyQuaternion(this._worldQuaternionInv),Ir.applyQuaternion(this._worldQuaternionInv),Ir.divide(_n),e.search("X")===-1&&(Ir.x=1),e.search("Y")===-1&&(Ir.y=1),e.search("Z")===-1&&(Ir.z=1);s.scale.copy(this._scaleStart).multiply(Ir),this.scaleSnap&&(e.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(_n.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;e==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(_n.copy(this.rotationAxis).cross(this.eye))*a):(e==="X"||e==="Y"||e==="Z")&&(this.rotationAxis.copy(mx[e]),_n.copy(mx[e]),r==="local"&&_n.applyQuaternion(this.worldQuaternion),_n.cross(this.eye),_n.length()===0?l=!0:this.rotationAngle=this._offset.dot(_n.normalize())*a),(e==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&e!=="E"&&e!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(ln.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(ln.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Kf),this.dispatchEvent(xx)}}pointerUp(t){t!==null&&t.button!==0||(this.dragging&&this.axis!==null&&(_x.mode=this.mode,this.dispatchEvent(_x)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(t){return this.object=t,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Kf),this.dispatchEvent(xx),this.pointStart.copy(this.pointEnd))}getRaycaster(){return to}getMode(){return this.mode}setMode(t){this.mode=t}setTranslationSnap(t){this.translationSnap=t}setRotationSnap(t){this.rotationSnap=t}setScaleSnap(t){this.scaleSnap=t}setSize(t){this.size=t}setSpace(t){this.space=t}setColors(t,e,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(t),r.yAxis.color.set(e),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(t),r.yAxisTransparent.color.set(e),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(t),r.yAxis._color&&r.yAxis._color.set(e),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(t),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(e),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function eR(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let t=this.domElement.getBoundingClientRect(),e=this.viewport,i,s,r,o;return e!==null?(i=e.x,s=t.height-e.y-e.w,r=e.z,o=e.w):(i=0,s=0,r=t.width,o=t.height),{x:(n.clientX-t.left-i)/r*2-1,y:-(n.clientY-t.top-s)/o*2+1,button:n.button}}}function nR(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function iR(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function sR(n){this.enabled&&this.pointerMove(this._getPointer(n))}function rR(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Qf(n,t,e){let i=t.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||e)return i[s];return!1}var uu=new Ui,Xe=new R(0,1,0),yx=new R(0,0,0),vx=new Kt,du=new Ie,pu=new Ie,Ms=new R,gu=new Kt,Dl=new R(1,0,0),eo=new R(0,1,0),Nl=new R(0,0,1),fu=new R,Il=new R,Ll=new R,tp=class extends un{constructor(t){super(),this.isTransformControlsRoot=!0,this.controls=t,this.visible=!1}updateMatrixWorld(t){let e=this.controls;e.object!==void 0&&(e.object.updateMatrixWorld(),e.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):e.object.parent.matrixWorld.decompose(e._parentPosition,e._parentQuaternion,e._parentScale),e.object.matrixWorld.decompose(e.worldPosition,e.worldQuaternion,e._worldScale),e._parentQuaternionInv.copy(e._parentQuaternion).invert(),e._worldQuaternionInv.copy(e.worldQuaternion).invert()),e.camera.updateMatrixWorld(),e.camera.matrixWorld.decompose(e.cameraPosition,e.cameraQuaternion,e._cameraScale),e.camera.isOrthographicCamera?e.camera.getWorldDirection(e.eye).negate():e.eye.copy(e.cameraPosition).sub(e.worldPosition).normalize(),this.parent&&(gu.copy(this.parent.matrixWorld).invert(),gu.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(t)}dispose(){this.traverse(function(t){t.geometry&&t.geometry.dispose(),t.material&&t.material.dispose()})}},ep=class extends un{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let t=new ai({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),e=new Bi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=t.clone();i.opacity=.15;let s=e.clone();s.opacity=.5;let r=t.clone();r.color.setHex(16711680);let o=t.clone();o.color.setHex(65280);let a=t.clone();a.color.setHex(255);let l=t.clone();l.color.setHex(16711680),l.opacity=.5;let c=t.clone();c.color.setHex(65280),c.opacity=.5;let u=t.clone();u.color.setHex(255),u.opacity=.5;let d=t.clone();d.opacity=.25;let h=t.clone();h.color.setHex(16776960),h.opacity=.25;let f=t.clone();f.color.setHex(16776960);let p=t.clone();p.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:u,activeTransparent:h};let g=new Ve(0,.04,.1,12);g.translate(0,.05,0);let m=new je(.08,.08,.08);m.translate(0,.04,0);let _=new we;_.setAttribute("position",new ie([0,0,0,1,0,0],3));let x=new Ve(.0075,.0075,.5,3);x.translate(0,.25,0);function S(z,Y){let V=new Ai(z,.0075,3,64,Y*Math.PI*2);return V.rotateY(Math.PI/2),V.rotateX(Math.PI/2),V}function y(){let z=new we;return z.setAttribute("position",new ie([0,0,0,1,1,1],3)),z}let C={X:[[new mt(g,r),[.5,0,0],[0,0,-Math.PI/2]],[new mt(g,r),[-.5,0,0],[0,0,Math.PI/2]],[new mt(x,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new mt(g,o),[0,.5,0]],[new mt(g,o),[0,-.5,0],[Math.PI,0,0]],[new mt(x,o)]],Z:[[new mt(g,a),[0,0,.5],[Math.PI/2,0,0]],[new mt(g,a),[0,0,-.5],[-Math.PI/2,0,0]],[new mt(x,a),null,[Math.PI/2,0,0]]],XYZ:[[new mt(new mr(.1,0),d),[0,0,0]]],XY:[[new mt(new je(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new mt(new je(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new je(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},A={X:[[new mt(new Ve(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new mt(new Ve(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new mt(new Ve(.2,0,.6,4),i),[0,.3,0]],[new mt(new Ve(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new mt(new Ve(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new mt(new Ve(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new mt(new mr(.2,0),i)]],XY:[[new mt(new je(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new mt(new je(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new je(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},v={START:[[new mt(new mr(.01,2),s),null,null,null,"helper"]],END:[[new mt(new mr(.01,2),s),null,null,null,"helper"]],DELTA:[[new Ei(y(),s),null,null,null,"helper"]],X:[[new Ei(_,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new Ei(_,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new Ei(_,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},M={XYZE:[[new mt(S(.5,1),p),null,[0,Math.PI/2,0]]],X:[[new mt(S(.5,.5),r)]],Y:[[new mt(S(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new mt(S(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new mt(S(.75,1),h),null,[0,Math.PI/2,0]]]},U={AXIS:[[new Ei(_,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new mt(new di(.25,10,8),i)]],X:[[new mt(new Ai(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new mt(new Ai(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new mt(new Ai(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new mt(new Ai(.75,.1,2,24),i)]]},L={X:[[new mt(m,r),[.5,0,0],[0,0,-Math.PI/2]],[new mt(x,r),[0,0,0],[0,0,-Math.PI/2]],[new mt(m,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new mt(m,o),[0,.5,0]],[new mt(x,o)],[new mt(m,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new mt(m,a),[0,0,.5],[Math.PI/2,0,0]],[new mt(x,a),[0,0,0],[Math.PI/2,0,0]],[new mt(m,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new mt(new je(.15,.15,.01),u),[.15,.15,0]]],YZ:[[new mt(new je(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new je(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new mt(new je(.1,.1,.1),d)]]},F={X:[[new mt(new Ve(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new mt(new Ve(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new mt(new Ve(.2,0,.6,4),i),[0,.3,0]],[new mt(new Ve(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new mt(new Ve(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new mt(new Ve(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new mt(new je(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new mt(new je(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new je(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new mt(new je(.2,.2,.2),i),[0,0,0]]]},G={X:[[new Ei(_,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new Ei(_,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new Ei(_,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function N(z){let Y=new un;for(let V in z)for(let ot=z[V].length;ot--;){let $=z[V][ot][0].clone(),K=z[V][ot][1],et=z[V][ot][2],ht=z[V][ot][3],ut=z[V][ot][4];$.name=V,$.tag=ut,K&&$.position.set(K[0],K[1],K[2]),et&&$.rotation.set(et[0],et[1],et[2]),ht&&$.scale.set(ht[0],ht[1],ht[2]),$.updateMatrix();let Q=$.geometry.clone();Q.applyMatrix4($.matrix),$.geometry=Q,$.renderOrder=1/0,$.position.set(0,0,0),$.rotation.set(0,0,0),$.scale.set(1,1,1),Y.add($)}return Y}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=N(C)),this.add(this.gizmo.rotate=N(M)),this.add(this.gizmo.scale=N(L)),this.add(this.picker.translate=N(A)),this.add(this.picker.rotate=N(P)),this.add(this.picker.scale=N(F)),this.add(this.helper.translate=N(v)),this.add(this.helper.rotate=N(U)),this.add(this.helper.scale=N(G)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(t){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:pu;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(ln.setFromEuler(uu.set(0,0,0)),o.quaternion.copy(i).multiply(ln),Math.abs(Xe.copy(Dl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(ln.setFromEuler(uu.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(ln),Math.abs(Xe.copy(eo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(ln.setFromEuler(uu.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(ln),Math.abs(Xe.copy(Nl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(ln.setFromEuler(uu.set(0,Math.PI/2,0)),Xe.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(vx.lookAt(yx,Xe,eo)),o.quaternion.multiply(ln),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),_n.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),_n.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(_n),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(Xe.copy(Dl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(Xe.copy(eo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(Xe.copy(Nl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(Xe.copy(Nl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(Xe.copy(Dl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(Xe.copy(eo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(du.copy(i),Xe.copy(this.eye).applyQuaternion(ln.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(vx.lookAt(this.eye,yx,eo)),o.name==="X"&&(ln.setFromAxisAngle(Dl,Math.atan2(-Xe.y,Xe.z)),ln.multiplyQuaternions(du,ln),o.quaternion.copy(ln)),o.name==="Y"&&(ln.setFromAxisAngle(eo,Math.atan2(Xe.x,Xe.z)),ln.multiplyQuaternions(du,ln),o.quaternion.copy(ln)),o.name==="Z"&&(ln.setFromAxisAngle(Nl,Math.atan2(Xe.y,Xe.x)),ln.multiplyQuaternions(du,ln),o.quaternion.copy(ln))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(t)}},np=class extends mt{constructor(){super(new Wr(1e5,1e5,2,2),new ai({visible:!1,wireframe:!0,side:an,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(t){let e=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(e="local"),fu.copy(Dl).applyQuaternion(e==="local"?this.worldQuaternion:pu),Il.copy(eo).applyQuaternion(e==="local"?this.worldQuaternion:pu),Ll.copy(Nl).applyQuaternion(e==="local"?this.worldQuaternion:pu),Xe.copy(Il),this.mode){case"translate":case"scale":switch(this.axis){case"X":Xe.copy(this.eye).cross(fu),Ms.copy(fu).cross(Xe);break;case"Y":Xe.copy(this.eye).cross(Il),Ms.copy(Il).cross(Xe);break;case"Z":Xe.copy(this.eye).cross(Ll),Ms.copy(Ll).cross(Xe);break;case"XY":Ms.copy(Ll);break;case"YZ":Ms.copy(fu);break;case"XZ":Xe.copy(Ll),Ms.copy(Il);break;case"XYZ":case"E":Ms.set(0,0,0);break}break;default:Ms.set(0,0,0)}Ms.length()===0?this.quaternion.copy(this.cameraQuaternion):(gu.lookAt(_n.set(0,0,0),Ms,Xe),this.quaternion.setFromRotationMatrix(gu)),super.updateMatrixWorld(t)}};var oR=["#d55e00","#009e73","#0072b2","#e69f00"],aR=["E","XYZE","XYZ","XY","YZ","XZ"],bx={move:.01,turn:Math.PI/12},ip=({position:n,quaternion:{x:t,y:e,z:i,w:s}})=>({position:n.toArray(),rotation:[s,t,e,i]});function lR(n,{position:t,rotation:[e,i,s,r]}){n.position.set(...t),n.quaternion.set(i,s,r,e).normalize(),n.updateMatrixWorld()}function Sx(n,t,e,i){let s=new mu(n.camera,n.canvas);s.setMode(t),s.setSpace(t==="rotate"?"local":"world"),s.setSize(e),s.addEventListener("change",n.draw),s.addEventListener("dragging-changed",({value:o})=>{n.controls.enabled=!o}),s.addEventListener("objectChange",i),s.setColors(...oR);let r=[];s.getHelper().traverse(o=>aR.includes(o.name)&&r.push(o));for(let o of r)o.removeFromParent();return n.scene.add(s.getHelper()),s}function wx(n,t){let e=new un;n.scene.add(e);let i=null,s=new Kt,r=()=>t(ip(e)),o=[],a=()=>{let g=Sx(n,"translate",.75,r),m=Sx(n,"rotate",.95,r);g.addEventListener("axis-changed",({value:_})=>{g.dragging||(m.enabled=i!==null&&_===null)}),o.push(g,m)},l=g=>{o[0]?.setTranslationSnap(g?bx.move:null),o[1]?.setRotationSnap(g?bx.turn:null)};for(let g of["keydown","keyup"])addEventListener(g,({key:m})=>m==="Shift"&&l(g==="keydown"));let c=()=>o.some(g=>g.dragging),u=()=>{i=null;for(let g of o)g.detach(),g.enabled=!1;n.draw()},d=(g,m)=>{o.length===0&&a(),i=m,lR(e,g),s=i.matrixWorld.clone().invert().multiply(e.matrixWorld);for(let _ of o)_.enabled=!0,_.attach(e);n.draw()},h=()=>{if(!i||c())return;i.matrixWorld.clone().multiply(s).decompose(e.position,e.quaternion,new R)},f=({by:g,about:m,angle:_})=>{if(!i)return null;g&&e.position.add(new R(...g)),m&&e.quaternion.premultiply(new Ie().setFromAxisAngle(new R(...m),_)),e.updateMatrixWorld();let x=ip(e);return t(x),x};return u(),{show:d,hide:u,goAlong:h,nudge:f,busy:()=>o.some(g=>g.enabled&&g.axis!==null),dragging:c,pose:()=>ip(e),shown:()=>i!==null}}var cR=5;function Mx(n,t,{joint:e,place:i},s){let r=new Ws,o=h=>{let{x:f,y:p}=n.ray(h);return r.setFromCamera(new Wt(f,p),n.camera),r},a=null,l=null,c=h=>{h.button===0&&(a={x:h.clientX,y:h.clientY},l=i.busy()?null:e.grab(o(h)),l&&(n.controls.enabled=!1,n.canvas.setPointerCapture(h.pointerId),n.canvas.classList.add("holding"),h.stopImmediatePropagation(),n.canvas.focus({preventScroll:!0})))},u=()=>{l&&(n.controls.enabled=!0),l=null,n.canvas.classList.remove("holding")},d=h=>{let f=a&&Math.hypot(h.clientX-a.x,h.clientY-a.y)<cR&&!l,p=i.dragging()||i.busy();if(a=null,u(),f&&!p&&h.type==="pointerup"){let[g]=o(h).intersectObjects(t.meshes(),!1);s(g?g.object.userData.body:-1)}};return n.canvas.addEventListener("pointerdown",c,{capture:!0}),n.canvas.addEventListener("pointermove",h=>l?.(o(h))),n.canvas.addEventListener("pointerup",d,{capture:!0}),n.canvas.addEventListener("pointercancel",d),n.canvas.addEventListener("pointerdown",()=>n.canvas.focus({preventScroll:!0})),{dragging:()=>l!==null}}var Ex={type:"change"},rp={type:"start"},Tx={type:"end"},_u=new fr,Ax=new Si,hR=Math.cos(70*ea.DEG2RAD),Dn=new R,pi=2*Math.PI,Ce={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},sp=1e-6,ha=class extends qr{constructor(t,e=null){super(t,e),this.state=Ce.NONE,this.target=new R,this.cursor=new R,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:vr.ROTATE,MIDDLE:vr.DOLLY,RIGHT:vr.PAN},this.touches={ONE:br.ROTATE,TWO:br.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new R,this._lastQuaternion=new Ie,this._lastTargetPosition=new R,this._quat=new Ie().setFromUnitVectors(t.up,new R(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new jo,this._sphericalDelta=new jo,this._scale=1,this._panOffset=new R,this._rotateStart=new Wt,this._rotateEnd=new Wt,this._rotateDelta=new Wt,this._panStart=new Wt,this._panEnd=new Wt,this._panDelta=new Wt,this._dollyStart=new Wt,this._dollyEnd=new Wt,this._dollyDelta=new Wt,this._dollyDirection=new R,this._mouse=new Wt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=dR.bind(this),this._onPointerDown=uR.bind(this),this._onPointerUp=fR.bind(this),this._onContextMenu=vR.bind(this),this._onMouseWheel=gR.bind(this),this._onKeyDown=_R.bind(this),this._onTouchStart=xR.bind(this),this._onTouchMove=yR.bind(this),this._onMouseDown=pR.bind(this),this._onMouseMove=mR.bind(this),this._interceptControlDown=bR.bind(this),this._interceptControlUp=SR.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ce.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ex),this.update(),this.state=Ce.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Dn.copy(e).sub(this.target),Dn.applyQuaternion(this._quat),this._spherical.setFromVector3(Dn),this.autoRotate&&this.state===Ce.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=pi:i>Math.PI&&(i-=pi),s<-Math.PI?s+=pi:s>Math.PI&&(s-=pi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Dn.setFromSpherical(this._spherical),Dn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Dn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Dn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new R(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new R(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Dn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(_u.origin.copy(this.object.position),_u.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(_u.direction))<hR?this.object.lookAt(this.target):(Ax.setFromNormalAndCoplanarPoint(this.object.up,this.target),_u.intersectPlane(Ax,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>sp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>sp||this._lastTargetPosition.distanceToSquared(this.target)>sp?(this.dispatchEvent(Ex),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?pi/60*this.autoRotateSpeed*t:pi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Dn.setFromMatrixColumn(e,0),Dn.multiplyScalar(-t),this._panOffset.add(Dn)}_panUp(t,e){this.screenSpacePanning===!0?Dn.setFromMatrixColumn(e,1):(Dn.setFromMatrixColumn(e,0),Dn.crossVectors(this.object.up,Dn)),Dn.multiplyScalar(t),this._panOffset.add(Dn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Dn.copy(s).sub(this.target);let r=Dn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-pi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(pi*this._rotateDelta.x/e.clientHeight),this._rotateUp(pi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Wt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function uR(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function dR(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function fR(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Tx),this.state=Ce.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function pR(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case vr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ce.DOLLY;break;case vr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}break;case vr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(rp)}function mR(n){switch(this.state){case Ce.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ce.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ce.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function gR(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ce.NONE||(n.preventDefault(),this.dispatchEvent(rp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Tx))}function _R(n){this.enabled!==!1&&this._handleKeyDown(n)}function xR(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case br.ROTATE:if(this.enableRotate===!1){this.state=Ce.NONE;break}this._handleTouchStartRotate(n),this.state=Ce.TOUCH_ROTATE;break;case br.PAN:if(this.enablePan===!1){this.state=Ce.NONE;break}this._handleTouchStartPan(n),this.state=Ce.TOUCH_PAN;break;default:this.state=Ce.NONE}break;case 2:switch(this.touches.TWO){case br.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ce.TOUCH_DOLLY_PAN;break;case br.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ce.TOUCH_DOLLY_ROTATE;break;default:this.state=Ce.NONE}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(rp)}function yR(n){switch(this._trackPointer(n),this.state){case Ce.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ce.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ce.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ce.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ce.NONE}}function vR(n){this.enabled!==!1&&n.preventDefault()}function bR(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function SR(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Cx=1.12;function Ol(n){let t=Math.abs(n.x)<.9?new R(1,0,0):new R(0,1,0);return t.addScaledVector(n,-t.dot(n)).normalize(),new R().crossVectors(t,n).multiplyScalar(1).addScaledVector(t,.7).addScaledVector(n,.6).normalize()}function xu(n){let t=new $r(-1,1,1,-1,.1,10);return t.up.copy(n),t}var wR=({min:n,max:t})=>[0,1,2,3,4,5,6,7].map(e=>new R(e&1?t.x:n.x,e&2?t.y:n.y,e&4?t.z:n.z));function MR(n,t,e){let i=new R,s=new R;n.matrixWorld.extractBasis(i,s,new R);let r=o=>Math.max(...wR(t).map(a=>Math.abs(a.sub(e).dot(o))));return{x:r(i),y:r(s)}}function ua(n,t){let e=n.userData.half??{x:1,y:1},i=Math.max(e.y,e.x/t);Object.assign(n,{left:-i*t,right:i*t,top:i,bottom:-i}),n.updateProjectionMatrix()}function Ul(n,t,e,i){let s=t.isEmpty()?new Be(new R(-1,-1,-1),new R(1,1,1)):t,r=s.getCenter(new R),o=s.getSize(new R).length()/2||1;n.position.copy(r).addScaledVector(i??Ol(n.up),4*o),n.near=.01*o,n.far=20*o,n.zoom=1,n.lookAt(r),n.updateMatrixWorld();let a=MR(n,s,r);return n.userData.half={x:Cx*a.x,y:Cx*a.y},ua(n,e),r}var ER=new R(0,1,0);function yu(n,t,e){let i=Ar(t/12),s=2*Math.ceil(.6*t/i),r=new cl(s*i,s,"#888888","#888888");r.material.transparent=!0,r.material.opacity=.28,r.quaternion.setFromUnitVectors(ER,e);let o=n.isEmpty()?new R:n.getCenter(new R),a=n.isEmpty()?0:n.getSize(new R).multiply(new R(...e.toArray().map(Math.abs))).length()/2;return r.position.copy(o).addScaledVector(e,-a),{grid:r,step:i}}var op=1024;function AR(n,{up:t,from:e,center:i,radius:s}){let r=new Yo(16777215,1.9),o=new R().crossVectors(t,e),a=e.clone().addScaledVector(t,1.3).addScaledVector(o,-.8).normalize();r.position.copy(i).addScaledVector(a,2*s),r.target.position.copy(i),r.castShadow=!0,r.shadow.mapSize.set(op,op);let l={left:-s,right:s,top:s,bottom:-s};Object.assign(r.shadow.camera,l,{near:.2*s,far:4*s}),r.shadow.normalBias=4*s/op,r.shadow.radius=4,n.add(r,r.target)}function vu(n,t,e,i){let s=new rl(16777215,9080729,i?1.3:1.6);s.position.copy(e);let r=new Yo(16777215,i?.7:1.8);r.position.set(-.6,.8,1),t.add(r),n.add(s,t),i&&AR(n,{...i,up:e})}var TR=[0,-1,1,-2,2,-3,3,-4,4],CR=(n,t)=>n.left<t.right&&t.left<n.right&&n.top<t.bottom&&t.top<n.bottom;function RR({x:n,y:t,width:e}){return TR.flatMap(i=>[n+6,n-6-e].map(s=>({left:s,right:s+e,top:t+(i-.5)*14,bottom:t+(i+.5)*14,far:i!==0})))}function Rx(n,{width:t,height:e},i=[]){let s=[...i],r=({left:o,right:a,top:l,bottom:c})=>o>=2&&a<=t-2&&l>=1&&c<=e-1;return[...n].sort((o,a)=>o.depth-a.depth).flatMap(o=>{let a=RR(o).find(l=>r(l)&&!s.some(c=>CR(l,c)));return a?(s.push(a),[{label:o,place:a}]):[]})}var ap="system-ui, sans-serif",PR=[["x","#d55e00",new R(1,0,0)],["y","#009e73",new R(0,1,0)],["z","#0072b2",new R(0,0,1)]];function lp(n,t,e,i,s,r){n.lineJoin="round",n.lineWidth=3.5,n.strokeStyle=r,n.strokeText(t,e,i),n.fillStyle=s,n.fillText(t,e,i)}function IR(n,t,e,i){let s=n.clone().project(t);return[(s.x+1)/2*e,(1-s.y)/2*i]}var LR=({width:n,height:t,compact:e})=>[{left:n-110,right:n,top:t-36,bottom:t},...e?[]:[{left:0,right:84,top:t-84,bottom:t}]];function bu(n,t,e,i,s=[]){let{width:r,height:o,ink:a,page:l,muted:c}=i;n.font=`600 12px ${ap}`,n.textBaseline="middle";let u=t.map(({position:h,text:f})=>{let p=h.clone().project(e),[g,m]=IR(h,e,r,o);return{x:g,y:m,depth:p.z,text:f,width:n.measureText(f).width}}),d=Rx(u,i,[...LR(i),...s]);n.strokeStyle=c??a,n.lineWidth=1;for(let{label:h,place:f}of d.filter(p=>p.place.far))n.beginPath(),n.moveTo(h.x,h.y),n.lineTo(f.left>h.x?f.left-2:f.right+2,(f.top+f.bottom)/2),n.stroke();for(let{label:h,place:f}of d)lp(n,h.text,f.left,(f.top+f.bottom)/2,a,l)}function Su(n,t,e,{width:i,height:s,ink:r,page:o}){let a=i*t.zoom/(t.right-t.left),l=Ar(50/a),c=i-16,u=s-14;n.strokeStyle=r,n.lineWidth=2,n.beginPath();let d=c-l*a;n.moveTo(d,u-4),n.lineTo(d,u),n.lineTo(c,u),n.lineTo(c,u-4),n.stroke(),n.font=`12px ${ap}`,n.textAlign="center",lp(n,`${he(l)} ${e}`,(d+c)/2,u-10,r,o),n.textAlign="left"}function DR(n,t){let e=n.dot(t);return e>.999?" up":e<-.999?" down":""}function wu(n,t,{height:e,ink:i,page:s},r=[]){let o=[r.some(Boolean)?64:42,e-40],a=24,l=PR.map(([c,u,d],h)=>({name:(r[h]?`${c} ${r[h]}`:c)+DR(d,t.up),color:u,v:d.clone().transformDirection(t.matrixWorldInverse)}));n.font=`600 11px ${ap}`,n.textAlign="center",n.textBaseline="middle";for(let{name:c,color:u,v:d}of l.sort((h,f)=>h.v.z-f.v.z)){n.strokeStyle=u,n.lineWidth=2.5,n.beginPath(),n.moveTo(...o),n.lineTo(o[0]+a*d.x,o[1]-a*d.y),n.stroke();let h=a+9,f=n.measureText(c).width/2+3,p=Math.sign(d.x)*Math.max(0,f-9)*Math.min(1,2*Math.abs(d.x)),g=Math.max(f,o[0]+h*d.x+p);lp(n,c,g,o[1]-h*d.y,i,s)}n.textAlign="left"}var NR=45,OR=.6,UR=250,FR=.28,Px=1.5;function Ix(){let n=document.createElement("canvas").getContext("webgl2");if(!n)return!0;let t=n.getExtension("WEBGL_debug_renderer_info"),e=n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER);return n.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(String(e))}function Lx(n,t){let e=new ia({canvas:n,antialias:!t,alpha:!0,stencil:!0});return e.setPixelRatio(1),e.shadowMap.enabled=!0,e.shadowMap.type=Xs,e.shadowMap.autoUpdate=!1,e}function Dx(n,t,e){let{canvas:i,renderer:s,scene:r,camera:o}=n,a=null,l=null,c=0,u=!1,d=f=>{let p=f?t?Px/n.ratio:1:OR,[g,m]=[n.width,n.height].map(_=>Math.max(1,Math.round(_*n.ratio*p)));(i.width!==g||i.height!==m)&&s.setSize(g,m,!1),n.grid.material.opacity=FR*Math.min(Px,p)},h=()=>{l===null&&!n.expecting&&n.paintNow(!0)};n.paintNow=(f=!(t||c>NR))=>{let p=performance.now();cancelAnimationFrame(l),l=null,n.expecting=!1,d(f);let g=n.shown.shadows&&f;s.shadowMap.needsUpdate=g,n.sun.castShadow=g;for(let m of n.preparing)m(f);s.render(r,o),e(),f&&(c=.5*c+.5*(performance.now()-p)),++n.paints;for(let m of n.painted)m();clearTimeout(a),f||(a=setTimeout(h,UR))},n.draw=()=>{u||(l??(l=requestAnimationFrame(()=>n.paintNow())))},n.hold=f=>{f!==u&&(u=f,f&&cancelAnimationFrame(l),f?l=null:n.draw())},n.isHeld=()=>u,n.setPixels=()=>d(!t),n.warm=f=>{let p=n.shown.shadows&&!t;n.sun.castShadow=p,s.compile(f,o,r)}}var Nx=1e-6;function cp(n){let{camera:t,width:e,height:i,insets:s}=n,r={width:Math.max(80,e-s.left-s.right),height:Math.max(80,i-s.top-s.bottom)};ua(t,r.width/r.height);let[o,a]=[e/r.width,i/r.height];t.left*=o,t.right*=o,t.top*=a,t.bottom*=a;let l={x:(s.right-s.left)/2,y:(s.bottom-s.top)/2};t.setViewOffset(e,i,l.x,l.y,e,i)}function Ox(n){let{camera:t,canvas:e,controls:i}=n;n.aim=()=>cp(n);let s=null;n.fit=(r=n.from,o=n.box)=>{n.from=r.clone().normalize(),i.target.copy(Ul(t,o,1,n.from));let a=o.getSize(new R).length();t.position.copy(i.target).addScaledVector(n.from,20*a),t.near=a,t.far=60*a,cp(n),i.update(),s={position:t.position.clone(),target:i.target.clone()},n.draw()},n.isFitted=()=>s!==null&&t.zoom===1&&t.position.distanceTo(s.position)<Nx*t.near&&i.target.distanceTo(s.target)<Nx*t.near,n.setInsets=r=>{n.insets={...n.insets,...r},cp(n),n.draw()},n.ray=({clientX:r,clientY:o})=>{let a=e.getBoundingClientRect(),l=2*(r-a.left)/a.width-1,c=1-2*(o-a.top)/a.height;return{x:l,y:c}},n.pixel=r=>{let o=r.clone().project(t),a=e.getBoundingClientRect();return{x:a.left+(o.x+1)/2*a.width,y:a.top+(1-o.y)/2*a.height}}}var Mu=new R(0,0,1),Ux=new Be(new R(-.15,-.15,0),new R(.15,.15,.15));function BR(n,t){n.furniture.removeFromParent(),n.camera.clear(),n.sun?.dispose(),n.grid?.dispose();let e=t.getSize(new R).length()||1;n.furniture=new Ee;let{grid:i}=yu(t,e,Mu);i.visible=n.shown.grid,n.grid=i;let s=t.getCenter(new R),r={from:n.from,center:s,radius:.75*e},o=new Ee;vu(o,n.camera,Mu,r),n.sun=o.children.find(({castShadow:a})=>a),n.furniture.add(i,o),n.scene.add(n.furniture)}function kR(n,t,e,i){let{camera:s,insets:r,ratio:o}=n,{left:a,right:l,top:c,bottom:u,zoom:d,view:h}=s,f=[s.matrixWorld.elements,a,l,c,u,d,h];return JSON.stringify([f,t,r,o,e,i])}function zR(n,t,e){let{width:i,height:s,insets:r,ratio:o,camera:a}=n,l={...e(),width:i,height:s},[c,u]=[n.labels(),n.covered()],d=kR(n,l,c,u);if(n.written===d)return;n.written=d,t.setTransform(o,0,0,o,0,0),t.clearRect(0,0,i,s),bu(t,c,a,l,u),t.translate(r.left,-r.bottom),wu(t,a,l);let{left:h,right:f,zoom:p}=a;t.translate(-r.left-r.right,0),Su(t,{left:1e3*h,right:1e3*f,zoom:p},"mm",l)}function Fx(n,t){let e=document.createElement("canvas");e.className="gl",e.tabIndex=0;let i=document.createElement("canvas");i.className="words",i.setAttribute("aria-hidden","true"),n.append(e,i);let s=Ix(),r=Lx(e,s),o=new Vr,a=xu(Mu),l={canvas:e,words:i,renderer:r,scene:o,camera:a,width:1,height:1,ratio:1,insets:{left:0,right:0,top:0,bottom:0},furniture:new Ee,shown:{grid:!0,shadows:!0},from:Ol(Mu),box:Ux.clone(),labels:()=>[],covered:()=>[],preparing:[],painted:[],expecting:!1,paints:0,written:null};Dx(l,s,()=>zR(l,i.getContext("2d"),t));let c=new ha(a,e);c.enableDamping=!1,c.addEventListener("change",l.draw),l.controls=c,l.look=d=>{l.box=d.isEmpty()?Ux.clone():d,BR(l,l.box),l.draw()},l.picture=()=>{l.paintNow(!0);let d=document.createElement("canvas");d.width=i.width,d.height=i.height;let h=d.getContext("2d");return h.fillStyle=t().page,h.fillRect(0,0,d.width,d.height),h.drawImage(e,0,0,d.width,d.height),h.drawImage(i,0,0),d};let u=()=>{l.width=Math.max(1,n.clientWidth),l.height=Math.max(1,n.clientHeight),l.ratio=Math.min(2,devicePixelRatio),i.width=Math.round(l.width*l.ratio),i.height=Math.round(l.height*l.ratio),l.written=null,l.aim(),l.isHeld()?l.setPixels():l.paintNow()};return Ox(l),l.hold(!0),l.look(new Be),l.fit(),new ResizeObserver(u).observe(n),u(),l}var GR=(n,t)=>!n||n.mode!==t.mode||n.bodies.length===0||!t.bodies.some(({owner:e})=>n.bodies.some(i=>i.owner===e)),VR=4,hp=(n,t)=>n.clone().expandByScalar(t*n.getSize(new R).length()),HR=({eye:n,target:t})=>new R(...n).sub(new R(...t));async function WR(n){let t=await fetch(`/mesh/${n}${location.search}`);if(!t.ok)throw new Error(`mesh ${n}: ${t.status} ${t.statusText}`);return t.arrayBuffer()}function Bx(n,t,e){let i=Fx(n,t),s=z_(WR),r=V_(i.scene,s,i.draw),o=fx(i.scene),a=J_(i.scene),l=K_(i.scene),c=W_(i.scene),u=px(i.scene,i.draw),d=ox(i,e.moveJoint),h=wx(i,e.place),f=Mx(i,r,{joint:d,place:h},e.select);i.preparing.push(P=>r.prepare(P,i.camera)),i.preparing.push(()=>o.sharpen(i.canvas.width/i.width)),i.warm(r.samples),i.warm(i.grid);let p=null,g=null,m=!1,_=!1,x=[],S=new Be,y=()=>i.box.getSize(new R).length()||1;function C(){!g||!_||(i.hold(!1),i.look(r.box()),m&&i.fit(HR(p)),m&&(S=hp(i.box,.03)),m=!1,v(g))}function A(){if(p.mode!=="motion"||!_||!i.isFitted())return;let P=r.box();S.containsBox(P)||!hp(i.box,VR).containsBox(P)||(S.union(hp(P,.15)),i.fit(i.from,S))}function v(P){g&&P.bodies.some((N,z)=>N!==g.bodies[z])&&u.clear(),g=P,r.pose(g),h.goAlong(),A();let L=o.pose(g),{forceScale:F}=a.pose(g,y());x=l.pose(g,y());let{held:G}=d;G()&&d.tell(g.joints[p.joints.indexOf(G().joint)]),e.changed({tensionEnd:L,forceScale:F,momentRadius:l.momentRadius()}),i.draw()}return{stage:i,bodies:r,lines:o,contacts:a,vectors:l,pads:u,joint:d,place:h,pointer:f,show:P=>{m||(m=GR(p,P)),m&&a.forget();let L=d.held()?.joint;p=P,g=null,x=[],_=!1,i.hold(m&&p.bodies.length>0);let F=r.show(p).then(()=>{_=p===P});o.show(p),i.isHeld()&&o.plain()&&i.warm(o.plain()),l.show(p),c.show(p,r.groups);let G=L&&p.joints.find(({name:N,hand:z})=>N===L.name&&z===L.hand);return d.show(G??null,G&&r.groups[G.body],d.held()?.value??0),F.then(C,N=>{i.hold(!1),e.failed(N)})},pose:P=>{if(!p||!v_(p,P))return!1;let L=g===null;return v(P),L&&m&&C(),!0},tips:()=>x,frame:()=>g,fitting:()=>m,complete:()=>_&&g!==null,meshCount:s.size}}function XR(){let n=null,t=()=>n??(n={ink:en("--ink"),page:en("--page"),muted:en("--muted")});return t.forget=()=>n=null,t}var $R=/^(world\.|motion\.open|motion\.record|hand\.|fit\.open)/;function qR(){let{protocol:n,host:t,search:e}=location;return`${n==="https:"?"wss:":"ws:"}//${t}/ws${e}`}function YR(n){n.call=(t,e)=>n.link.call(t,e),n.ask=async(t,e={})=>{try{let i=await n.call(t,e);return $R.test(t)&&i?.warnings?.length&&n.notices.tell(i.warnings.join(`
`)),i}catch(i){return i.code!=="lost"&&n.notices.error(`${t}: ${i.message}`),null}},n.mayLeave=async()=>!n.store.state?.world?.unsaved||Tl("The world has changes that are not saved.","Go on without them"),n.newWorld=async()=>await n.mayLeave()&&n.ask("world.new"),n.save=()=>f_(n)}function ZR(n){let t=Math.random().toString(36).slice(2),e=0,i={pointers:new Set,keys:new Set},s=()=>e+=1;n.gesture=()=>`${t} ${e}`,addEventListener("pointerdown",({pointerId:r})=>i.pointers.add(r),!0),addEventListener("keydown",({code:r})=>i.keys.add(r),!0);for(let r of["pointerup","pointercancel"])addEventListener(r,({pointerId:o})=>{i.pointers.delete(o),s()});addEventListener("keyup",({code:r})=>{i.keys.delete(r),i.pointers.size===0&&s()}),addEventListener("blur",()=>{i.pointers.clear(),i.keys.clear(),s()}),addEventListener("change",()=>i.pointers.size+i.keys.size===0&&s())}function jR(n){let{store:t}=n,e=Qs(({method:s,params:r})=>n.ask(s,r),nu);n.canMove=()=>Gf(t.scene?.mode,{},0)!==null,n.moveJoint=(s,r)=>{let o=Gf(t.scene.mode,s,r,n.gesture());return o?(n.wanted={joint:s,value:r},n.notices.say(I_(t.scene,s,r)),e(o).finally(()=>{n.wanted?.joint===s&&n.wanted.value===r&&(n.wanted=null)})):null};let i=Qs(s=>n.ask("world.place",s),M_);n.moveSelected=({position:s,rotation:r})=>t.selected&&i({name:t.selected.owner,position:s,rotation:r,gesture:n.gesture()}),n.poseOf=s=>{let r=t.scene?.bodies.findIndex(o=>o.owner===s)??-1;return r<0||!t.frame?null:[...t.frame.bodies.subarray(7*r,7*r+3)]}}async function JR(n,t){let e=await n.ask("world.get");return[...e?.hands??[],...e?.bodies??[]].find(i=>i.name===t)??null}function KR(n){let{store:t}=n;n.select=async(e,{quiet:i=!1}={})=>{let{scene:s,frame:r}=t,o=e&&s?.bodies.some(({owner:h})=>h===e.owner),a=s?.joints.find(h=>h.hand===e?.owner&&h.name===e.joint),l=o||a?{owner:e.owner,joint:a?.name}:null;if(JSON.stringify(l)===JSON.stringify(t.selected))return;n.picture.bodies.select(l?.owner??null);let c=a&&r?r.joints[s.joints.indexOf(a)]:0;if(n.picture.joint.show(a??null,a&&n.picture.bodies.groups[a.body],c),n.picture.place.hide(),t.set({selected:l}),!l)return n.notices.say("nothing is selected");if(i||n.notices.say(`${l.joint??l.owner} selected`),a||s.mode!=="world")return;let u=Er(s).find(({name:h})=>h===l.owner);if(!u.movable)return;let d=await JR(n,l.owner);d&&t.selected===l&&n.picture.place.show(d,n.picture.bodies.groups[u.bodies[0]])},n.clicked=e=>{if(e<0)return n.select(null);let{scene:i}=t,s=i.joints[S_(i,e)],{owner:r}=i.bodies[e],o=s&&t.selected?.joint===s.name&&t.selected.owner===r;return n.select({owner:r,joint:o?void 0:s?.name})},n.hide=(e,i)=>{n.picture.bodies.hide(e,i),t.set({hidden:{}}),n.picture.stage.draw()}}function QR(n){let{picture:t}=n,{stage:e}=t,i=()=>{t.frame()&&t.pose(t.frame()),e.draw()};n.view={opacity:(s,r)=>{t.bodies.opacity(s,r),e.draw()},grid:s=>{e.shown.grid=s,e.grid.visible=s,e.draw()},shadows:s=>{e.shown.shadows=s,e.draw()},names:s=>{n.names=s,e.draw()},contacts:(s,r)=>{t.contacts.show[s]=r,i()},lines:s=>{t.lines.visible(s),e.draw()},vectors:s=>{t.vectors.visible(s),i()},fit:()=>{e.look(t.bodies.box()),e.fit()}},e.labels=()=>tP(n),e.covered=()=>D_(e,n.legend.box())}function tP(n){let{scene:t}=n.store;if(!t)return[];let e=n.picture.tips().filter(({i:s})=>t.arrows[s].kind!=="axis").map(({position:s,i:r})=>({position:s,text:t.arrows[r].name})),i=n.names?n.picture.bodies.meshes().map(s=>({position:new R().setFromMatrixPosition(s.parent.matrixWorld),text:t.bodies[s.userData.body].name})):[];return[...e,...i]}function eP(n){let{store:t}=n,e=null,i=()=>{let a=e;e=null,n.picture.stage.draw(),a&&n.picture.pose(a)&&(n.picture.stage.isHeld()||n.picture.stage.paintNow(),t.set({frame:a}),!n.firstFrame&&!n.picture.fitting()&&kx(n))};n.heardFrame=a=>{let l=e!==null;e=g_(a),n.frameAt=performance.now(),n.picture.stage.expecting=!0,l||requestAnimationFrame(i)};let o={scene:a=>{let l=t.selected,c=n.picture.show(a);t.set({scene:a,frame:null}),l&&!a.bodies.some(({owner:d})=>d===l.owner)?n.select(null):l&&(t.selected=null,n.select(l,{quiet:!0}));let u=a.bodies.length===0;c.then(()=>(n.picture.frame()||u)&&!n.firstFrame&&kx(n))},state:a=>{t.set({state:a}),n.notices.busy(a.busy??null)},progress:n.notices.progress,ended:({reason:a})=>n.notices.error(`thenar ended: ${a??"no reason was given"}`),failed:({text:a})=>n.notices.error(a),error:({message:a})=>n.notices.error(a??"an error without words")};n.heardNotice=(a,l)=>o[a]?.(l)}function kx(n){n.firstFrame=!0,requestAnimationFrame(()=>{let{paints:t}=n.picture.stage;performance.mark("thenar first picture",{detail:{paints:t}})})}function nP(n){let t=()=>n.store.state?.world?.name||"thenar",e=null;n.savePicture=()=>j0(n.picture,t()),n.saveGltf=()=>K0(n.ask,t()),n.saveCharts=()=>{J0()||n.notices.tell("No chart is shown: plot a sweep, or let time pass.")},n.film=async()=>{if(e){let i=e;return e=null,await i(t()),!1}return e=t_(n.picture),!0},addEventListener("beforeprint",()=>{document.querySelector(".printed")?.remove();let i=n.picture.stage.picture();i.className="printed",document.body.append(i)}),addEventListener("afterprint",()=>document.querySelector(".printed")?.remove())}function zx(n,t){let e={store:y_({link:!1,scene:null,frame:null,state:null,selected:null,hidden:{},tab:"pose"}),names:!1,wanted:null};e.link=x_(qR(),{frame:r=>e.heardFrame(r),notice:(r,o)=>e.heardNotice(r,o),link:r=>{e.notices.link(r),r.connected||e.notices.busy(null),r.connected||e.picture.stage.hold(!1),e.store.set({link:r.connected})}}),e.notices=R_(n,()=>e.ask("session.stop")),e.legend=C_(),n.append(e.legend);let i=XR();e.picture=Bx(t,i,{moveJoint:(r,o)=>e.moveJoint(r,o),place:r=>e.moveSelected(r),select:r=>e.clicked(r),failed:r=>e.notices.error(r.message),changed:r=>e.legend.show(r)});let s=[YR,ZR,jR,KR,QR,eP,nP];for(let r of s)r(e);return e.importFiles=d_(e),km(()=>{i.forget(),e.picture.stage.draw(),document.querySelectorAll(".chart").forEach(r=>r.redraw?.())}),e}function Gx(n,t,e){let i=new ha(n,t);return i.enableDamping=!1,i.enableZoom=!1,t.style.touchAction="pan-y",t.addEventListener("pointerdown",()=>t.focus({preventScroll:!0})),t.addEventListener("focus",()=>{i.enableZoom=!0}),t.addEventListener("blur",()=>{i.enableZoom=!1}),i.addEventListener("change",e),i}var Eu=Math.PI/24,up=1.15;function Au(n,t,e){let i={ArrowLeft:()=>n.rotateLeft(Eu),ArrowRight:()=>n.rotateLeft(-Eu),ArrowUp:()=>n.rotateUp(Eu),ArrowDown:()=>n.rotateUp(-Eu),"+":()=>n.dollyOut(up),"=":()=>n.dollyOut(up),"-":()=>n.dollyIn(up),0:e,Home:e};t.addEventListener("keydown",s=>{s.ctrlKey||s.altKey||s.metaKey||!Object.hasOwn(i,s.key)||(s.preventDefault(),i[s.key]())})}var iP={x:[1,0,0],y:[0,1,0],z:[0,0,1]},dp={ArrowLeft:-1,ArrowRight:1,ArrowDown:-10,ArrowUp:10},sP=.001,rP=Math.PI/180,oP=["pose","grasp","tendons","fit","time"],aP=({target:n})=>n.matches?.("input, select, textarea")||document.querySelector("dialog[open]"),Wx=({ctrlKey:n,altKey:t,metaKey:e})=>!n&&!t&&!e;function Xx(n){let t=s=>document.getElementById(s)?.click(),e={z:s=>t(s.shiftKey?"redo":"undo"),y:()=>t("redo"),o:()=>t("open"),s:()=>t("save")},i={"?":()=>n.help(),Escape:()=>n.select(null),g:()=>t("do-grasp"),o:()=>t("do-open"),c:()=>t("do-close"),".":()=>n.stepTime(1)};oP.forEach((s,r)=>i[r+1]=()=>n.tabs.choose(s)),addEventListener("keydown",s=>{if(aP(s))return;let r=(s.ctrlKey||s.metaKey)&&!s.altKey,o=s.key.length===1?s.key.toLowerCase():s.key,a=r?e[o]:Wx(s)?i[o]:null;if(a)return s.preventDefault(),a(s);s.key===" "&&!s.target.matches("button, summary, a")&&(s.preventDefault(),n.togglePlay())})}function Vx(n,t){let e=Er(n.store.scene??{bodies:[]});if(!e.length)return;let i=e.findIndex(({name:r})=>r===n.store.selected?.owner),s=i<0?t>0?0:e.length-1:(i+t+e.length)%e.length;n.select({owner:e[s].name})}function Hx(n,t){let{scene:e,selected:i}=n.store,s=i?.owner??e?.joints[0]?.hand,r=(e?.joints??[]).filter(l=>l.hand===s&&!l.led_by);if(!r.length)return;let o=r.findIndex(({name:l})=>l===i?.joint),a=o<0?t>0?0:r.length-1:(o+t+r.length)%r.length;n.select({owner:s,joint:r[a].name})}function lP(n,t){let{scene:e,frame:i,selected:s}=n.store,r=e.joints.findIndex(c=>c.hand===s.owner&&c.name===s.joint),o=e.joints[r];if(!o||!i)return;let a=n.wanted?.joint===o?n.wanted.value:i.joints[r],{scale:l}=Zs(o);n.moveJoint(o,_s(a+t*l,o.lower,o.upper))}function $x(n){let{stage:t,place:e}=n.picture,i={axis:"x",turns:!1},s=()=>n.notices.say(`arrow keys ${i.turns?"turn about":"move along"} ${i.axis}`),r=c=>{let u=iP[i.axis],d=i.turns?e.nudge({about:u,angle:c*rP}):e.nudge({by:new R(...u).multiplyScalar(c*sP).toArray()});if(!d)return;t.draw();let h=d.position.map(f=>(f*1e3).toFixed(1)).join(", ");n.notices.say(`${n.store.selected.owner} at ${h} mm`)},o=c=>()=>{Object.assign(i,c),s()},a={x:o({axis:"x"}),y:o({axis:"y"}),z:o({axis:"z"}),t:o({turns:!1}),r:o({turns:!0}),PageDown:()=>Vx(n,1),PageUp:()=>Vx(n,-1),"]":()=>Hx(n,1),"[":()=>Hx(n,-1)},l={"+":1,"=":1,"-":-1,_:-1,"*":10};t.canvas.addEventListener("keydown",c=>{if(!Wx(c))return;let{selected:u}=n.store,d=h=>{c.preventDefault(),c.stopImmediatePropagation(),h()};if(Object.hasOwn(a,c.key))return d(a[c.key]);if(u?.joint){let h=l[c.key]??dp[c.key];h&&d(()=>lP(n,h*(c.shiftKey&&h**2===1?10:1)))}else e.shown()&&dp[c.key]&&d(()=>r(dp[c.key]))},{capture:!0}),Au(t.controls,t.canvas,()=>n.view.fit())}function fp(n,t,e={}){let i=js("menu");t.id=i,t.classList.add("items");let s=De(n,()=>o(s.getAttribute("aria-expanded")!=="true"),{class:"opener","aria-expanded":"false","aria-controls":i,...e}),r=X("div",{class:"menu"},s,t);function o(a){if(s.setAttribute("aria-expanded",String(a)),r.classList.toggle("open",a),a){let{left:l,bottom:c}=s.getBoundingClientRect();t.style.setProperty("--left",`${Math.max(8,Math.min(l,innerWidth-250))}px`),t.style.setProperty("--top",`${c+4}px`),t.querySelector("button, input")?.focus()}}return r.addEventListener("keydown",a=>{a.key!=="Escape"||!r.classList.contains("open")||(a.stopPropagation(),o(!1),s.focus())}),addEventListener("pointerdown",({target:a})=>r.contains(a)||o(!1)),r.addEventListener("click",({target:a})=>{a.closest(".items")&&a.matches("button")&&o(!1)}),r}function cP(n){let t=X("div",{},ke("New",n.newWorld,{id:"new",title:"An empty world"}),De("Open",()=>n.openDialog(),{id:"open",title:"Worlds, scenes, digits, hands, objects (Ctrl+O)"}),ke("Save",n.save,{id:"save",title:"Save or download the world (Ctrl+S)"}),De("Import",()=>n.importFiles(),{id:"import",title:"Meshes, robots, worlds; or drop files onto the picture"})),e=fp("File",t);return e.classList.add("file"),e}function hP(n){let t=ke("Begin a film",async()=>{t.textContent=await n.film()?"End the film":"Begin a film"},{id:"film"});return fp("Export",X("div",{},ke("Picture (PNG)",n.savePicture,{id:"export-png"}),ke("Scene (glTF)",n.saveGltf,{id:"export-gltf"}),ke("Charts (SVG)",n.saveCharts,{id:"export-svg"}),t,De("Print the picture",()=>print())))}function uP(n){let{picture:t,view:e}=n,i=(r,o)=>{let a=xs({name:r,lower:0,upper:1,quantity:Vi.share},l=>e.opacity(o,l));return a.set(t.bodies.opacities[o]),a},s=(r,o,a)=>Al(r,o,a);return fp("View",X("div",{class:"view-menu"},i("skin","hands"),i("objects","objects"),s("grid",!0,e.grid),s("shadows",!0,e.shadows),s("names",!1,e.names),s("contacts",!0,r=>e.contacts("contacts",r)),s("friction cones",!0,r=>e.contacts("cones",r)),s("contact forces",!0,r=>e.contacts("forces",r)),s("tendons",!0,e.lines),s("arrows",!0,e.vectors),De("Show everything",()=>e.fit())))}function qx(n){let{store:t}=n,e=X("span",{class:"world-name"}),i=X("span",{class:"link",role:"status"}),s=ke("Undo",()=>n.ask("session.undo"),{id:"undo"}),r=ke("Redo",()=>n.ask("session.redo"),{id:"redo"}),o=X("header",{class:"bar"},X("h1",{},"thenar"),cP(n),X("div",{class:"group"},s,r),hP(n),uP(n),De("?",()=>n.help(),{id:"help","aria-label":"Help: all keys",title:"Help (?)"}),e,i),a=()=>{let{state:l,link:c}=t;s.disabled=!l?.undo,r.disabled=!l?.redo,s.title=l?.undo?`Undo: ${l.undo} (Ctrl+Z)`:"Nothing to undo",r.title=l?.redo?`Redo: ${l.redo} (Ctrl+Y)`:"Nothing to redo";let u=l?.world??{};e.textContent=[u.name??"",u.unsaved?"(not saved)":""].filter(Boolean).join(" "),document.title=u.name?`${u.name} \u2013 thenar`:"thenar";let d=(l?.clients??1)-1;i.className=c?"link on":"link off",i.textContent=c?d>0?`connected, with ${d} more`:"connected":"not connected"};return t.on(["state","link"],a),a(),o}var dP=["x","y","z"],fP=.3333333333333333;function no(n,[t,e,i,s]){let r=[e,i,s],o=(l,c)=>[l[1]*c[2]-l[2]*c[1],l[2]*c[0]-l[0]*c[2],l[0]*c[1]-l[1]*c[0]],a=o(r,n).map((l,c)=>l+t*n[c]);return o(r,a).map((l,c)=>n[c]+2*l)}var Zx=(n,t)=>[...no(n.slice(0,3),t),...no(n.slice(3),t)];function jx(n,t){return!n||t<0||7*t+7>n.bodies.length?null:[...n.bodies.subarray(7*t+3,7*t+7)]}var Yx=(n,t)=>n.flatMap((e,i)=>t>0&&Math.abs(e)>=fP*t?[`${e>0?"+":"\u2212"}${dP[i]}`]:[]);function pp(n){let t=Math.max(...n.map(Math.abs)),e=Yx(n.slice(0,3),t).map(s=>`force along ${s}`),i=Yx(n.slice(3),t).map(s=>`torque about ${s}`);return[...e,...i].join(", ")||"none"}var Tu=(n,t)=>Math.abs(n)<1e-9*t?0:n;var io=n=>n?n.map(t=>he(t,2)).join(", "):"n/a",Jx=({trial:n,specimen:t,posture:e,loads:i})=>[`${n+1}`,t,e,i].filter(s=>s&&s!=="").join(" "),pP="Components along the experiment's own axes; arrows show the same forces in the picture.",mP="Reference posture; along x, y, z of the picture, from the subject's origin.",Kx=Math.PI/180;function mp({value:n,lower:t,upper:e},i,s){let r=a=>he(a===null?NaN:a/i,1),o=t===e?"":` (${r(t)} to ${r(e)})`;return`${r(n)}${o}${s}`}var gP=({angle:n,distance:t,beyond:e})=>[["Angle",mp(n,Kx,"\xB0")],["Distance",mp(t,.001,"\u202Fmm")],["Second lies distal by",mp(e,.001,"\u202Fmm")]],_P=({direction:n,point:t},e)=>[["Direction",io(no(n,e))],["Point",`${io(no(t,e).map(i=>i*1e3))} mm`]];function Qx(n){let{store:t}=n,e=X("p",{class:"hint"},"No fit is shown."),i=Qh("Fit",h=>n.ask("fit.open",{file:h})),s=Ln("Trial",async h=>{await n.ask("fit.trial",{trial:Number(h)}),d()}),r=X("div",{}),o=Js(["trial","measured [N]","predicted [N]"],[],"Forces"),a=X("div",{class:"parts"}),l=X("div",{class:"parts"},s,We("This trial",r,X("p",{class:"hint"},pP)),We("All trials",o),We("Axes",X("p",{class:"hint"},mP),a)),c=X("div",{class:"page fit"},e,i,la(n),l);function u(h){let f=h.trials;s.set(f.map(g=>({value:String(g.trial),text:Jx(g)})),String(h.trial));let p=f.find(g=>g.trial===h.trial);r.replaceChildren(ys(p?[["Measured",`${io(p.measured)} N`],["Predicted",`${io(p.predicted)} N`],["Standard deviation",`${io(p.sd)} N`],["Direction off by",`${he(p.direction_error/Kx,1)}\xB0`]]:[]),...(h.warnings??[]).map(g=>X("p",{class:"warning"},g))),Ks(o.querySelector("tbody"),f.map(g=>[Jx(g),io(g.measured),io(g.predicted)])),a.replaceChildren(...h.pairs.map(g=>We(g.axes,ys(gP(g)))),...h.axes.map(g=>We(g.joint,ys(_P(g,h.rotation)))))}async function d(){let h=t.scene?.mode==="fit";if(e.hidden=h,l.hidden=!h,!h||c.hidden)return;let f=await n.ask("fit.state");f&&u(f)}return t.on(["scene","tab"],d),d(),c}var xP=20,yP=n=>[n.link,he(n.depth*1e3,2),he(n.area*1e6,1),`${he(100*n.stick,0)} %`];function ty(n,t){let e=1,i=xs({name:"force of each",lower:.1,upper:xP,quantity:Vi.force},l=>e=l);i.set(e);let r=Js(["pad","depth [mm]","area [mm\xB2]","sticks"],[],"Pads");r.hidden=!0;let o=X("p",{class:"hint"});return We("Pads",i,X("div",{class:"buttons"},ke("Press",async()=>{let l=await n.ask("grasp.pads",{...t(),force:e});l&&(r.hidden=l.pads.length===0,Ks(r.querySelector("tbody"),l.pads.map(yP)),o.textContent=l.reasons.length?l.reasons.join(`
`):"On the picture: blue points stick, orange ones slip; larger is more pressure.",n.picture.pads.show(l.pads.flatMap(({points:c})=>c)))},{id:"press-pads"})),r,o)}var vP=new R(0,1,0);function Fl(n,t,e){return n.position.copy(t).add(e).multiplyScalar(.5),n.quaternion.setFromUnitVectors(vP,e.clone().sub(t).normalize()),n}function ey({a:n,b:t,radius:e},{material:i,size:s}){let r=new R(...n),o=new R(...t),a=new mt(new Hr(e??.02*s,r.distanceTo(o),8,20),i);return Fl(a,r,o),a.userData.labelAt=a.position.clone(),a}function ny({positions:n,radius:t},{material:e,size:i}){let s=new Gs(new di(t??.008*i,12,8),e,n.length);return n.forEach((r,o)=>s.setMatrixAt(o,new Kt().makeTranslation(...r))),s.userData.labelAt=new R(...n[0]??[0,0,0]),s}var bP=.5;function iy({tip:n,axis:t,radius:e},{color:i}){let s=new R(...n),r=s.clone().add(new R(...t)),o=new Jn({color:i,transparent:!0,opacity:bP,side:an,depthWrite:!1}),a=s.distanceTo(r),l=Fl(new mt(new ki(e,a,28,1,!0),o),r,s);return l.userData.labelAt=s,l}function sy(n,t,e,i,s){let r=t.clone().sub(n),o=r.length(),a=new Ee;if(o===0)return a;let l=Math.min(i,.5*o),c=t.clone().addScaledVector(r,-l/o);return a.add(Fl(new mt(new Ve(e,e,o-l,12),s),n,c)),a.add(Fl(new mt(new ki(2.6*e,l,16),s),c,t)),a}function ry({from:n,vector:t,radius:e},{material:i,size:s}){let r=new R(...n),o=r.clone().add(new R(...t)),a=sy(r,o,e??.005*s,.035*s,i);return a.userData.labelAt=o,a}function oy({point:n,direction:t,length:e},{material:i,size:s}){let r=new R(...t).normalize().multiplyScalar((e??.2*s)/2),o=new R(...n),a=o.clone().add(r),l=sy(o.clone().sub(r),a,.0035*s,.025*s,i);return l.userData.labelAt=a,l}var SP=.3,ay=Math.PI/2,ly={cylinder:([n,t])=>new Ve(n,n,2*t,40,1,!0).rotateX(ay),sphere:([n])=>new di(n,32,20),ellipsoid:([n,t,e])=>new di(1,32,20).scale(n,t,e),capsule:([n,t])=>new Hr(n,2*t,12,32).rotateX(ay),torus:([n,t])=>new Ai(t,n,16,48)},nk=Object.keys(ly);function cy({shape:n,size:[t,e=0,i=0]}){return n==="cylinder"?Math.hypot(t,e):n==="ellipsoid"?Math.max(t,e,i):n==="sphere"?t:t+e}function hy({shape:n,size:t,center:e,axes:i},{color:s}){let r=new Jn({color:s,transparent:!0,opacity:SP,side:an,depthWrite:!1}),o=new mt(ly[n](t),r),[a,l,c]=i.map(u=>new R(...u));return o.applyMatrix4(new Kt().makeBasis(a,l,c).setPosition(...e)),o.userData.hull=!0,o.userData.labelAt=new R(...e),o}var wP=65536,MP=.62,_p=n=>Uint8Array.from(atob(n),t=>t.charCodeAt(0)).buffer;function EP(n){let t=new Uint8Array(_p(n)),e=new Float32Array(t.length),i=new Zt;for(let s=0;s<t.length;s+=3)i.setRGB(t[s]/255,t[s+1]/255,t[s+2]/255,"srgb").toArray(e,s);return e}function AP({vertices:n,origin:t,step:e,triangles:i,crease:s,colors:r}){let o=new Int16Array(_p(n)),a=Float32Array.from(o,(u,d)=>t[d%3]+e*u),l=a.length/3>wP?Uint32Array:Uint16Array,c=new we;if(c.setAttribute("position",new Ze(a,3)),r&&c.setAttribute("color",new Ze(EP(r),3)),c.setIndex(new Ze(new l(_p(i)),1)),s===void 0)c.computeVertexNormals();else return iu(c,s*Math.PI/180);return c}var gp=new WeakMap;function uy(n){return gp.has(n)||gp.set(n,AP(n)),gp.get(n)}function dy({rotation:n,position:t=[0,0,0]}){let[e,i,s]=n??[[1,0,0],[0,1,0],[0,0,1]],[[r,o,a],[l,c,u],[d,h,f]]=[e,i,s],[p,g,m]=t;return new Kt().set(r,o,a,p,l,c,u,g,d,h,f,m,0,0,0,1)}function fy(n,t){let e=dy(t),{position:i}=uy(t.mesh).attributes,s=new R;for(let r=0;r<i.count;++r)n.expandByPoint(s.fromBufferAttribute(i,r).applyMatrix4(e))}function TP(n,t,e){n.solids??(n.solids=new Map);let i=`${t} ${e}`;return n.solids.has(i)||n.solids.set(i,new nl({color:e?16777215:n.color,vertexColors:e,roughness:MP,transparent:t<1,opacity:t,depthWrite:t===1,side:t<1?an:0})),n.solids.get(i)}function py(n,t){let{mesh:e,opacity:i=1}=n,s=new mt(uy(e),TP(t,i,e.colors!==void 0));return s.applyMatrix4(dy(n)),s.castShadow=s.receiveShadow=!0,s.userData.hull=i<1,s.geometry.computeBoundingSphere(),s.userData.labelAt=s.geometry.boundingSphere.center.clone().applyMatrix4(s.matrix),s}var da=class extends Pr{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setPositions(i),this}setColors(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setColors(i),this}setFromPoints(t){let e=t.length-1,i=new Float32Array(6*e);for(let s=0;s<e;s++)i[6*s]=t[s].x,i[6*s+1]=t[s].y,i[6*s+2]=t[s].z||0,i[6*s+3]=t[s+1].x,i[6*s+4]=t[s+1].y,i[6*s+5]=t[s+1].z||0;return super.setPositions(i),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Cu=class extends ca{constructor(t=new da,e=new vs({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var CP=.35,RP=.15,PP=2.5;function IP(n,t){let e=new we;e.setAttribute("position",new ie(n.flat(),3)),e.setIndex(t.flat());let i=e.toNonIndexed();return i.computeVertexNormals(),i}function my({vertices:n,faces:t},{color:e}){let i=IP(n,t),s=new Ee,r=new Jn({color:e,transparent:!0,opacity:CP,side:an,depthWrite:!1});return s.add(new mt(i,r),new Vs(new tl(i,5),new Bi({color:e}))),s.children[0].userData.hull=!0,i.computeBoundingSphere(),s.userData.labelAt=i.boundingSphere?.center??new R,s}function gy({positions:n,dashed:t=!1,width:e=PP},{color:i,size:s}){if(n.length<2)return new Ee;let r=new vs({color:i,linewidth:e*(globalThis.devicePixelRatio??1),dashed:t,dashSize:.015*s,gapSize:.01*s}),o=new Cu(new da().setPositions(n.flat()),r);return o.computeLineDistances(),o.userData.labelAt=new R(...n[Math.floor(n.length/2)]),o}function _y({positions:n,opacity:t=RP},{color:e}){let i=new we;i.setAttribute("position",new ie(n.flat(),3));let s=new Bi({color:e,transparent:!0,opacity:t,depthWrite:!1}),r=new Vs(i,s);return r.userData.labelAt=new R(...n[0]??[0,0,0]),r}var LP={segment:ey,axis:oy,arrow:ry,hull:my,points:ny,line:gy,lines:_y,surface:hy,mesh:py,cone:iy},Ru=n=>n!==null&&typeof n=="object"?Object.entries(n).every(([t,e])=>t==="label"||Ru(e)):n!==null&&!Number.isNaN(n);function DP(n){let t=new Map;return e=>(t.has(e)||t.set(e,{color:new Zt(e),material:new Jn({color:e}),size:n}),t.get(e))}function NP(n,t){let e=new Ee,i=[],s=DP(t),r=n.items.filter(Ru);for(let o of r){let a=LP[o.kind](o,s(o.color??n.color));a.userData.item=o,e.add(a),o.label&&i.push({position:a.userData.labelAt,text:o.label})}return e.name=n.name,e.visible=n.visible!==!1,{group:e,labels:i,name:n.name,color:n.color,time:n.time??null,lost:n.items.length-r.length}}var xy=(n,t)=>n.map(e=>NP(e,t));var xp=(n,t,e)=>n.map((i,s)=>i+e*t[s]);function OP(n){let t=Math.hypot(...n)||1;return n.map(e=>e/t)}function UP(n){return n.kind==="segment"?[n.a,n.b]:n.kind==="arrow"?[n.from,xp(n.from,n.vector,1)]:n.kind==="cone"?[n.tip,xp(n.tip,n.axis,1)]:n.kind==="axis"?[-.5,.5].map(t=>xp(n.point,OP(n.direction),t*(n.length??0))):n.kind==="surface"?[-1,1].map(t=>n.center.map(e=>e+t*cy(n))):n.vertices??n.positions}function yy(n){let t=new Be,e=new R,i=n.filter(({fit:s})=>s!==!1);for(let s of i.flatMap(r=>r.items).filter(Ru)){if(s.kind==="mesh"){fy(t,s);continue}for(let r of UP(s))t.expandByPoint(e.fromArray(r));if(s.radius&&s.kind==="segment")for(let r of[s.a,s.b])for(let o of[-1,1])t.expandByPoint(e.fromArray(r).addScalar(o*s.radius))}return t}var vy=n=>n.isEmpty()?1:n.getSize(new R).length()||1;var Lr=class n{constructor(t,e,i,s,r="div"){this.parent=t,this.object=e,this.property=i,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),n.nextNameID=n.nextNameID||0,this.$name.id=`lil-gui-name-${++n.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(i)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},yp=class extends Lr{constructor(t,e,i){super(t,e,i,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function vp(n){let t,e;return(t=n.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=n.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=n.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var FP={isPrimitive:!0,match:n=>typeof n=="string",fromHexString:vp,toHexString:vp},kl={isPrimitive:!0,match:n=>typeof n=="number",fromHexString:n=>parseInt(n.substring(1),16),toHexString:n=>"#"+n.toString(16).padStart(6,0)},BP={isPrimitive:!1,match:n=>Array.isArray(n)||ArrayBuffer.isView(n),fromHexString(n,t,e=1){let i=kl.fromHexString(n);t[0]=(i>>16&255)/255*e,t[1]=(i>>8&255)/255*e,t[2]=(i&255)/255*e},toHexString([n,t,e],i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return kl.toHexString(s)}},kP={isPrimitive:!1,match:n=>Object(n)===n,fromHexString(n,t,e=1){let i=kl.fromHexString(n);t.r=(i>>16&255)/255*e,t.g=(i>>8&255)/255*e,t.b=(i&255)/255*e},toHexString({r:n,g:t,b:e},i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return kl.toHexString(s)}},zP=[FP,kl,BP,kP];function GP(n){return zP.find(t=>t.match(n))}var bp=class extends Lr{constructor(t,e,i,s){super(t,e,i,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=GP(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=vp(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Bl=class extends Lr{constructor(t,e,i){super(t,e,i,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},Sp=class extends Lr{constructor(t,e,i,s,r,o){super(t,e,i,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let x=parseFloat(this.$input.value);isNaN(x)||(this._stepExplicit&&(x=this._snap(x)),this.setValue(this._clamp(x)))},i=x=>{let S=parseFloat(this.$input.value);isNaN(S)||(this._snapClampSetValue(S+x),this.$input.value=this.getValue())},s=x=>{x.key==="Enter"&&this.$input.blur(),x.code==="ArrowUp"&&(x.preventDefault(),i(this._step*this._arrowKeyMultiplier(x))),x.code==="ArrowDown"&&(x.preventDefault(),i(this._step*this._arrowKeyMultiplier(x)*-1))},r=x=>{this._inputFocused&&(x.preventDefault(),i(this._step*this._normalizeMouseWheel(x)))},o=!1,a,l,c,u,d,h=5,f=x=>{a=x.clientX,l=c=x.clientY,o=!0,u=this.getValue(),d=0,window.addEventListener("mousemove",p),window.addEventListener("mouseup",g)},p=x=>{if(o){let S=x.clientX-a,y=x.clientY-l;Math.abs(y)>h?(x.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(S)>h&&g()}if(!o){let S=x.clientY-c;d-=S*this._step*this._arrowKeyMultiplier(x),u+d>this._max?d=this._max-u:u+d<this._min&&(d=this._min-u),this._snapClampSetValue(u+d)}c=x.clientY},g=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",p),window.removeEventListener("mouseup",g)},m=()=>{this._inputFocused=!0},_=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",m),this.$input.addEventListener("blur",_)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(_,x,S,y,C)=>(_-x)/(S-x)*(C-y)+y,e=_=>{let x=this.$slider.getBoundingClientRect(),S=t(_,x.left,x.right,this._min,this._max);this._snapClampSetValue(S)},i=_=>{this._setDraggingStyle(!0),e(_.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=_=>{e(_.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,l,c=_=>{_.preventDefault(),this._setDraggingStyle(!0),e(_.touches[0].clientX),o=!1},u=_=>{_.touches.length>1||(this._hasScrollBar?(a=_.touches[0].clientX,l=_.touches[0].clientY,o=!0):c(_),window.addEventListener("touchmove",d,{passive:!1}),window.addEventListener("touchend",h))},d=_=>{if(o){let x=_.touches[0].clientX-a,S=_.touches[0].clientY-l;Math.abs(x)>Math.abs(S)?c(_):(window.removeEventListener("touchmove",d),window.removeEventListener("touchend",h))}else _.preventDefault(),e(_.touches[0].clientX)},h=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",d),window.removeEventListener("touchend",h)},f=this._callOnFinishChange.bind(this),p=400,g,m=_=>{if(Math.abs(_.deltaX)<Math.abs(_.deltaY)&&this._hasScrollBar)return;_.preventDefault();let S=this._normalizeMouseWheel(_)*this._step;this._snapClampSetValue(this.getValue()+S),this.$input.value=this.getValue(),clearTimeout(g),g=setTimeout(f,p)};this.$slider.addEventListener("mousedown",i),this.$slider.addEventListener("touchstart",u,{passive:!1}),this.$slider.addEventListener("wheel",m,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:i}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,i=-t.wheelDelta/120,i*=this._stepExplicit?1:10),e+-i}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},wp=class extends Lr{constructor(t,e,i,s){super(t,e,i,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let i=document.createElement("option");i.textContent=e,this.$select.appendChild(i)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},Mp=class extends Lr{constructor(t,e,i){super(t,e,i,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},VP=`.lil-gui {
  font-family: var(--font-family);
  font-size: var(--font-size);
  line-height: 1;
  font-weight: normal;
  font-style: normal;
  text-align: left;
  color: var(--text-color);
  user-select: none;
  -webkit-user-select: none;
  touch-action: manipulation;
  --background-color: #1f1f1f;
  --text-color: #ebebeb;
  --title-background-color: #111111;
  --title-text-color: #ebebeb;
  --widget-color: #424242;
  --hover-color: #4f4f4f;
  --focus-color: #595959;
  --number-color: #2cc9ff;
  --string-color: #a2db3c;
  --font-size: 11px;
  --input-font-size: 11px;
  --font-family: -apple-system, BlinkMacSystemFont, "Segoe UI", Roboto, Arial, sans-serif;
  --font-family-mono: Menlo, Monaco, Consolas, "Droid Sans Mono", monospace;
  --padding: 4px;
  --spacing: 4px;
  --widget-height: 20px;
  --title-height: calc(var(--widget-height) + var(--spacing) * 1.25);
  --name-width: 45%;
  --slider-knob-width: 2px;
  --slider-input-width: 27%;
  --color-input-width: 27%;
  --slider-input-min-width: 45px;
  --color-input-min-width: 45px;
  --folder-indent: 7px;
  --widget-padding: 0 0 0 3px;
  --widget-border-radius: 2px;
  --checkbox-size: calc(0.75 * var(--widget-height));
  --scrollbar-width: 5px;
}
.lil-gui, .lil-gui * {
  box-sizing: border-box;
  margin: 0;
  padding: 0;
}
.lil-gui.lil-root {
  width: var(--width, 245px);
  display: flex;
  flex-direction: column;
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-title {
  background: var(--title-background-color);
  color: var(--title-text-color);
}
.lil-gui.lil-root > .lil-children {
  overflow-x: hidden;
  overflow-y: auto;
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar {
  width: var(--scrollbar-width);
  height: var(--scrollbar-width);
  background: var(--background-color);
}
.lil-gui.lil-root > .lil-children::-webkit-scrollbar-thumb {
  border-radius: var(--scrollbar-width);
  background: var(--focus-color);
}
@media (pointer: coarse) {
  .lil-gui.lil-allow-touch-styles, .lil-gui.lil-allow-touch-styles .lil-gui {
    --widget-height: 28px;
    --padding: 6px;
    --spacing: 6px;
    --font-size: 13px;
    --input-font-size: 16px;
    --folder-indent: 10px;
    --scrollbar-width: 7px;
    --slider-input-min-width: 50px;
    --color-input-min-width: 65px;
  }
}
.lil-gui.lil-force-touch-styles, .lil-gui.lil-force-touch-styles .lil-gui {
  --widget-height: 28px;
  --padding: 6px;
  --spacing: 6px;
  --font-size: 13px;
  --input-font-size: 16px;
  --folder-indent: 10px;
  --scrollbar-width: 7px;
  --slider-input-min-width: 50px;
  --color-input-min-width: 65px;
}
.lil-gui.lil-auto-place, .lil-gui.autoPlace {
  max-height: 100%;
  position: fixed;
  top: 0;
  right: 15px;
  z-index: 1001;
}

.lil-controller {
  display: flex;
  align-items: center;
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
}
.lil-controller.lil-disabled {
  opacity: 0.5;
}
.lil-controller.lil-disabled, .lil-controller.lil-disabled * {
  pointer-events: none !important;
}
.lil-controller > .lil-name {
  min-width: var(--name-width);
  flex-shrink: 0;
  white-space: pre;
  padding-right: var(--spacing);
  line-height: var(--widget-height);
}
.lil-controller .lil-widget {
  position: relative;
  display: flex;
  align-items: center;
  width: 100%;
  min-height: var(--widget-height);
}
.lil-controller.lil-string input {
  color: var(--string-color);
}
.lil-controller.lil-boolean {
  cursor: pointer;
}
.lil-controller.lil-color .lil-display {
  width: 100%;
  height: var(--widget-height);
  border-radius: var(--widget-border-radius);
  position: relative;
}
@media (hover: hover) {
  .lil-controller.lil-color .lil-display:hover:before {
    content: " ";
    display: block;
    position: absolute;
    border-radius: var(--widget-border-radius);
    border: 1px solid #fff9;
    top: 0;
    right: 0;
    bottom: 0;
    left: 0;
  }
}
.lil-controller.lil-color input[type=color] {
  opacity: 0;
  width: 100%;
  height: 100%;
  cursor: pointer;
}
.lil-controller.lil-color input[type=text] {
  margin-left: var(--spacing);
  font-family: var(--font-family-mono);
  min-width: var(--color-input-min-width);
  width: var(--color-input-width);
  flex-shrink: 0;
}
.lil-controller.lil-option select {
  opacity: 0;
  position: absolute;
  width: 100%;
  max-width: 100%;
}
.lil-controller.lil-option .lil-display {
  position: relative;
  pointer-events: none;
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  line-height: var(--widget-height);
  max-width: 100%;
  overflow: hidden;
  word-break: break-all;
  padding-left: 0.55em;
  padding-right: 1.75em;
  background: var(--widget-color);
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-display.lil-focus {
    background: var(--focus-color);
  }
}
.lil-controller.lil-option .lil-display.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-option .lil-display:after {
  font-family: "lil-gui";
  content: "\u2195";
  position: absolute;
  top: 0;
  right: 0;
  bottom: 0;
  padding-right: 0.375em;
}
.lil-controller.lil-option .lil-widget,
.lil-controller.lil-option select {
  cursor: pointer;
}
@media (hover: hover) {
  .lil-controller.lil-option .lil-widget:hover .lil-display {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number input {
  color: var(--number-color);
}
.lil-controller.lil-number.lil-has-slider input {
  margin-left: var(--spacing);
  width: var(--slider-input-width);
  min-width: var(--slider-input-min-width);
  flex-shrink: 0;
}
.lil-controller.lil-number .lil-slider {
  width: 100%;
  height: var(--widget-height);
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
  padding-right: var(--slider-knob-width);
  overflow: hidden;
  cursor: ew-resize;
  touch-action: pan-y;
}
@media (hover: hover) {
  .lil-controller.lil-number .lil-slider:hover {
    background: var(--hover-color);
  }
}
.lil-controller.lil-number .lil-slider.lil-active {
  background: var(--focus-color);
}
.lil-controller.lil-number .lil-slider.lil-active .lil-fill {
  opacity: 0.95;
}
.lil-controller.lil-number .lil-fill {
  height: 100%;
  border-right: var(--slider-knob-width) solid var(--number-color);
  box-sizing: content-box;
}

.lil-dragging .lil-gui {
  --hover-color: var(--widget-color);
}
.lil-dragging * {
  cursor: ew-resize !important;
}
.lil-dragging.lil-vertical * {
  cursor: ns-resize !important;
}

.lil-gui .lil-title {
  height: var(--title-height);
  font-weight: 600;
  padding: 0 var(--padding);
  width: 100%;
  text-align: left;
  background: none;
  text-decoration-skip: objects;
}
.lil-gui .lil-title:before {
  font-family: "lil-gui";
  content: "\u25BE";
  padding-right: 2px;
  display: inline-block;
}
.lil-gui .lil-title:active {
  background: var(--title-background-color);
  opacity: 0.75;
}
@media (hover: hover) {
  body:not(.lil-dragging) .lil-gui .lil-title:hover {
    background: var(--title-background-color);
    opacity: 0.85;
  }
  .lil-gui .lil-title:focus {
    text-decoration: underline var(--focus-color);
  }
}
.lil-gui.lil-root > .lil-title:focus {
  text-decoration: none !important;
}
.lil-gui.lil-closed > .lil-title:before {
  content: "\u25B8";
}
.lil-gui.lil-closed > .lil-children {
  transform: translateY(-7px);
  opacity: 0;
}
.lil-gui.lil-closed:not(.lil-transition) > .lil-children {
  display: none;
}
.lil-gui.lil-transition > .lil-children {
  transition-duration: 300ms;
  transition-property: height, opacity, transform;
  transition-timing-function: cubic-bezier(0.2, 0.6, 0.35, 1);
  overflow: hidden;
  pointer-events: none;
}
.lil-gui .lil-children:empty:before {
  content: "Empty";
  padding: 0 var(--padding);
  margin: var(--spacing) 0;
  display: block;
  height: var(--widget-height);
  font-style: italic;
  line-height: var(--widget-height);
  opacity: 0.5;
}
.lil-gui.lil-root > .lil-children > .lil-gui > .lil-title {
  border: 0 solid var(--widget-color);
  border-width: 1px 0;
  transition: border-color 300ms;
}
.lil-gui.lil-root > .lil-children > .lil-gui.lil-closed > .lil-title {
  border-bottom-color: transparent;
}
.lil-gui + .lil-controller {
  border-top: 1px solid var(--widget-color);
  margin-top: 0;
  padding-top: var(--spacing);
}
.lil-gui .lil-gui .lil-gui > .lil-title {
  border: none;
}
.lil-gui .lil-gui .lil-gui > .lil-children {
  border: none;
  margin-left: var(--folder-indent);
  border-left: 2px solid var(--widget-color);
}
.lil-gui .lil-gui .lil-controller {
  border: none;
}

.lil-gui label, .lil-gui input, .lil-gui button {
  -webkit-tap-highlight-color: transparent;
}
.lil-gui input {
  border: 0;
  outline: none;
  font-family: var(--font-family);
  font-size: var(--input-font-size);
  border-radius: var(--widget-border-radius);
  height: var(--widget-height);
  background: var(--widget-color);
  color: var(--text-color);
  width: 100%;
}
@media (hover: hover) {
  .lil-gui input:hover {
    background: var(--hover-color);
  }
  .lil-gui input:active {
    background: var(--focus-color);
  }
}
.lil-gui input:disabled {
  opacity: 1;
}
.lil-gui input[type=text],
.lil-gui input[type=number] {
  padding: var(--widget-padding);
  -moz-appearance: textfield;
}
.lil-gui input[type=text]:focus,
.lil-gui input[type=number]:focus {
  background: var(--focus-color);
}
.lil-gui input[type=checkbox] {
  appearance: none;
  width: var(--checkbox-size);
  height: var(--checkbox-size);
  border-radius: var(--widget-border-radius);
  text-align: center;
  cursor: pointer;
}
.lil-gui input[type=checkbox]:checked:before {
  font-family: "lil-gui";
  content: "\u2713";
  font-size: var(--checkbox-size);
  line-height: var(--checkbox-size);
}
@media (hover: hover) {
  .lil-gui input[type=checkbox]:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui button {
  outline: none;
  cursor: pointer;
  font-family: var(--font-family);
  font-size: var(--font-size);
  color: var(--text-color);
  width: 100%;
  border: none;
}
.lil-gui .lil-controller button {
  height: var(--widget-height);
  text-transform: none;
  background: var(--widget-color);
  border-radius: var(--widget-border-radius);
}
@media (hover: hover) {
  .lil-gui .lil-controller button:hover {
    background: var(--hover-color);
  }
  .lil-gui .lil-controller button:focus {
    box-shadow: inset 0 0 0 1px var(--focus-color);
  }
}
.lil-gui .lil-controller button:active {
  background: var(--focus-color);
}

@font-face {
  font-family: "lil-gui";
  src: url("data:application/font-woff2;charset=utf-8;base64,d09GMgABAAAAAALkAAsAAAAABtQAAAKVAAEAAAAAAAAAAAAAAAAAAAAAAAAAAAAAHFQGYACDMgqBBIEbATYCJAMUCwwABCAFhAoHgQQbHAbIDiUFEYVARAAAYQTVWNmz9MxhEgodq49wYRUFKE8GWNiUBxI2LBRaVnc51U83Gmhs0Q7JXWMiz5eteLwrKwuxHO8VFxUX9UpZBs6pa5ABRwHA+t3UxUnH20EvVknRerzQgX6xC/GH6ZUvTcAjAv122dF28OTqCXrPuyaDER30YBA1xnkVutDDo4oCi71Ca7rrV9xS8dZHbPHefsuwIyCpmT7j+MnjAH5X3984UZoFFuJ0yiZ4XEJFxjagEBeqs+e1iyK8Xf/nOuwF+vVK0ur765+vf7txotUi0m3N0m/84RGSrBCNrh8Ee5GjODjF4gnWP+dJrH/Lk9k4oT6d+gr6g/wssA2j64JJGP6cmx554vUZnpZfn6ZfX2bMwPPrlANsB86/DiHjhl0OP+c87+gaJo/gY084s3HoYL/ZkWHTRfBXvvoHnnkHvngKun4KBE/ede7tvq3/vQOxDXB1/fdNz6XbPdcr0Vhpojj9dG+owuSKFsslCi1tgEjirjXdwMiov2EioadxmqTHUCIwo8NgQaeIasAi0fTYSPTbSmwbMOFduyh9wvBrESGY0MtgRjtgQR8Q1bRPohn2UoCRZf9wyYANMXFeJTysqAe0I4mrherOekFdKMrYvJjLvOIUM9SuwYB5DVZUwwVjJJOaUnZCmcEkIZZrKqNvRGRMvmFZsmhP4VMKCSXBhSqUBxgMS7h0cZvEd71AWkEhGWaeMFcNnpqyJkyXgYL7PQ1MoSq0wDAkRtJIijkZSmqYTiSImfLiSWXIZwhRh3Rug2X0kk1Dgj+Iu43u5p98ghopcpSo0Uyc8SnjlYX59WUeaMoDqmVD2TOWD9a4pCRAzf2ECgwGcrHjPOWY9bNxq/OL3I/QjwEAAAA=") format("woff2");
}`;function HP(n){let t=document.createElement("style");t.innerHTML=n;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var by=!1,Pu=class n{constructor({parent:t,autoPlace:e=t===void 0,container:i,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:l=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),l&&this.domElement.classList.add("lil-allow-touch-styles"),!by&&a&&(HP(VP),by=!0),i?i.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,i,s,r){if(Object(i)===i)return new wp(this,t,e,i);let o=t[e];switch(typeof o){case"number":return new Sp(this,t,e,i,s,r);case"boolean":return new yp(this,t,e);case"string":return new Mp(this,t,e);case"function":return new Bl(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,i=1){return new bp(this,t,e,i)}addFolder(t){let e=new n({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(i=>{i instanceof Bl||i._name in t.controllers&&i.load(t.controllers[i._name])}),e&&t.folders&&this.folders.forEach(i=>{i._title in t.folders&&i.load(t.folders[i._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(i=>{if(!(i instanceof Bl)){if(i._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${i._name}"`);e.controllers[i._name]=i.save()}}),t&&this.folders.forEach(i=>{if(i._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${i._title}"`);e.folders[i._title]=i.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let i=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",i))};this.$children.addEventListener("transitionend",i);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(i=>i.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};var WP=700,XP=400;function $P(n,{group:t,name:e,color:i},s){let r=n.add(t,"visible").name(e).onChange(s);r.domElement.style.setProperty("--layer",i),r.domElement.classList.add("layer")}function qP(n){let t=[];for(let{group:e}of n)e.traverse(i=>i.userData.hull&&t.push(i.material));return t}function YP(n,t,e){let i=qP(t);if(!i.length)return;let s={"surface opacity":i[0].opacity};n.add(s,"surface opacity",0,1,.05).onChange(r=>{for(let o of i)o.opacity=r;e()})}function Sy(n,t){let e=new Pu({container:n,title:"Layers",width:190});for(let i of t.layers)i.time===null&&$P(e,i,t.draw);return YP(e,t.layers,t.draw),t.layers.some(i=>i.labels.length)&&e.add(t.show,"labels").onChange(t.draw),e.add(t.grid,"visible").name("grid").onChange(t.draw),e.add(t,"fit").name("fit view"),n.clientWidth<WP&&e.close(),e.onOpenClose(()=>setTimeout(t.draw,XP)),e}var Ep=new Map,Ap=!1;function ZP(n,t){let e=t.view.camera.position.clone().sub(t.controls.target),i=n.view.camera.position.distanceTo(n.controls.target);n.view.camera.position.copy(n.controls.target).addScaledVector(e.normalize(),i),n.view.camera.zoom=t.view.camera.zoom,n.view.camera.updateProjectionMatrix(),n.controls.update(),n.view.draw()}function wy(n,t,e){let i=Ep.get(n)??[],s={view:t,controls:e};Ep.set(n,[...i,s]),e.addEventListener("change",()=>{Ap||(Ap=!0,Ep.get(n).filter(r=>r!==s).forEach(r=>ZP(r,s)),Ap=!1)})}var My=5,jP=.6,JP=n=>n.material?.transparent?n.material.opacity:1;function*Tp(n){for(let t=n;t;t=t.parent)yield t}var KP=n=>[...Tp(n)].every(({visible:t})=>t),QP=n=>[...Tp(n)].find(({userData:t})=>t.item)?.userData.item??null,tI=n=>n.isMesh===!0&&JP(n)>jP,eI=n=>n.find(({object:t})=>tI(t))??n[0];function nI({object:n,face:t,point:e}){let i=n.geometry?.attributes?.color;if(!i||!t||!n.material.vertexColors)return null;let{position:s}=n.geometry.attributes,r=n.worldToLocal(e.clone()),o=[t.a,t.b,t.c],[a,l,c]=o.map(f=>new R().fromBufferAttribute(s,f)),u=l.clone().sub(a).cross(c.clone().sub(a)),d=(f,p)=>f.sub(r).cross(p.sub(r)).dot(u)/u.lengthSq(),h=[d(l.clone(),c.clone()),d(c.clone(),a.clone()),d(a.clone(),l.clone())];return[0,1,2].map(f=>h.reduce((p,g,m)=>p+g*i.getComponent(o[m],f),0))}function Ey({camera:n,layers:t},{x:e,y:i},s){let r=new Ws;r.setFromCamera(new Wt(e,i),n);let o=My*(n.top-n.bottom)/(2*s*n.zoom);r.params.Line.threshold=o,r.params.Line2={threshold:2*My};let a=t.map(({group:h})=>h).filter(({visible:h})=>h);a.forEach(h=>h.updateMatrixWorld());let l=r.intersectObjects(a,!0).filter(({object:h})=>KP(h));if(!l.length)return null;let c=eI(l),u=[...Tp(c.object)];return{layer:t.find(({group:h})=>u.includes(h)),item:QP(c.object),point:c.point,color:nI(c)}}var fa=null;function Cp(){return fa||(fa=new ia({antialias:!0,alpha:!0}),fa.shadowMap.enabled=!0,fa.shadowMap.type=Xs,fa)}function Ay(n,t,e){let{width:i,height:s}=n.canvas,r=Cp(),o=r.domElement;(o.width!==i||o.height!==s)&&r.setSize(i,s,!1),r.render(t,e),n.clearRect(0,0,i,s),n.drawImage(r.domElement,0,0)}function iI(n){let t=document.createElement("canvas");return t.tabIndex=0,t.setAttribute("role","img"),t.setAttribute("aria-label",`${n.dataset.label??"3D view"}; arrow keys turn, plus and minus zoom, 0 fits`),n.append(t),t}function sI(n,t,e,i){return!n.some(({items:r})=>r.some(({kind:o})=>o==="mesh"))||t.isEmpty()?null:{from:i,center:t.getCenter(new R),radius:.75*e}}function rI({layers:n,up:t=[0,0,1],view:e}){let i=yy(n),s=vy(i),r=new R(...t).normalize(),o=new Vr,a=xu(r),l=xy(n,s),{grid:c}=yu(i,s,r);c.visible=n.every(({fit:d})=>d!==!1),o.add(c,...l.map(d=>d.group));let u=e?new R(...e).normalize():Ol(r);return vu(o,a,r,sI(n,i,s,u)),{scene:o,camera:a,box:i,grid:c,layers:l,show:{labels:!0},from:u}}function oI(n){if(!n)return[];let{offsetLeft:t,offsetTop:e,offsetWidth:i,offsetHeight:s}=n.domElement;return[{left:t,top:e,right:t+i,bottom:e+s}]}function Ry(n,t,e,{unit:i="mm",compact:s,axes:r},o,a){let{canvas:l}=t,c={width:l.width/o,height:l.height/o},u={...e(),...c,compact:s};Ay(t,n.scene,n.camera),t.save(),t.scale(o,o);let d=n.layers.filter(h=>h.group.visible).flatMap(h=>h.labels);n.show.labels&&bu(t,d,n.camera,u,a),s||wu(t,n.camera,u,r),Su(t,n.camera,i,u),t.restore()}function Ty(n,t){n.traverse(({material:e})=>{e?.isLineMaterial&&(e.linewidth*=t)})}function Py(n,t,e,i,s){let r=document.createElement("canvas");r.width=Math.max(1,Math.round(t.width*s)),r.height=Math.max(1,Math.round(t.height*s));let o=r.getContext("2d"),a=s/devicePixelRatio;return Ty(n.scene,a),ua(n.camera,r.width/r.height),Ry(n,o,e,i,s,[]),Ty(n.scene,1/a),o.globalCompositeOperation="destination-over",o.fillStyle=e().page,o.fillRect(0,0,r.width,r.height),r}function aI(n,t,e,i,s){let r=n.camera.clone(!1);return Ul(r,n.box,t.width/t.height,n.from),Py({...n,camera:r},t,e,{...i,compact:!0},s)}function Cy(n,t){return n.width=Math.max(1,Math.round(t.clientWidth*devicePixelRatio)),n.height=Math.max(1,Math.round(t.clientHeight*devicePixelRatio)),n.width/n.height}function lI(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Iy(n,t,e){Cp();let i=iI(n),s=i.getContext("2d"),r=rI(t),o=()=>Ry(r,s,e,t,devicePixelRatio,oI(r.panel));r.draw=lI(o);let a=()=>({width:n.clientWidth,height:n.clientHeight});r.picture=c=>Py(r,a(),e,t,c),r.still=(c,u)=>aI(r,c,e,t,u),r.paintNow=o,r.canvas=i,r.at=({clientX:c,clientY:u})=>{let{left:d,top:h,width:f,height:p}=i.getBoundingClientRect(),g={x:2*(c-d)/f-1,y:1-2*(u-h)/p};return Ey(r,g,p/2)};let l=Gx(r.camera,i,r.draw);return r.fit=()=>{l.target.copy(Ul(r.camera,r.box,i.width/i.height,r.from)),l.update(),r.draw()},i.addEventListener("dblclick",r.fit),Au(l,i,r.fit),Cy(i,n),r.fit(),t.compact||(r.panel=Sy(n,r)),t.link&&wy(t.link,r,l),new ResizeObserver(()=>{n.clientWidth&&(ua(r.camera,Cy(i,n)),o())}).observe(n),r.lost=r.layers.reduce((c,u)=>c+u.lost,0),r}var Ly=["Fx","Fy","Fz","Tx","Ty","Tz"],Rp={"force, no torque":{axes:[0,1,2],kind:"slice"},"torque, no force":{axes:[3,4,5],kind:"slice"},"force, any torque":{axes:[0,1,2],kind:"projection"},"torque, any force":{axes:[3,4,5],kind:"projection"},"three axes":null},cI=[{limits:"geometric",title:"Contacts alone",color:"#0072b2"},{limits:"actuated",title:"With the hand's limits",color:"#d55e00",note:"Efforts limit what the hand presses, but not what palm, joint limits and drives that cannot be driven back bear: their strength is unknown, so that sets may be far larger than any hand is."}],Dy="#8a8f99";function hI(n,t){let e=s=>Math.max(1e-9,...n.map(r=>Math.abs(r[s]))),i=Math.max(e(0),e(1),e(2));return t.map((s,r)=>{let o=[0,0,0];return o[r]=1.15*Math.max(e(r),.25*i),{kind:"arrow",from:[0,0,0],vector:o,label:Ly[s],color:Dy}})}function uI(n,t,e,i){let s=X("div",{class:"scene small"});s.dataset.label=`${n.title}: set of wrenches`;let r=t.vertices.length<4,o="The set has no volume along these axes.",a=t.failed?`; ${t.failed} directions have no bound`:"",l=X("figcaption",{},`${n.title} [${t.unit}]${a}`);if(r)s.append(X("p",{class:"hint"},o));else{let u={kind:"hull",vertices:t.vertices,faces:t.triangles},h={layers:[{name:"set",color:n.color,items:[u]},{name:"axes",color:Dy,items:hI(t.vertices,e)}],compact:!0,unit:t.unit.split(" ")[0],link:i};requestAnimationFrame(()=>Iy(s,h,()=>({ink:en("--ink"),page:en("--page")})))}let c=n.note?X("p",{class:"hint beside"},n.note):null;return X("figure",{class:"wrenches"},s,l,c)}var dI=0;function Ny(n,t){let e=X("div",{class:"pair"}),i=[0,1,2].map(l=>{let c=Ln(`Axis ${l+1}`,()=>{});return c.set(Ly.map((u,d)=>({value:String(d),text:u})),String(l)),c}),s=X("div",{class:"axes",hidden:!0},...i),r=Ln("Set",l=>s.hidden=Rp[l]!==null);r.set(Object.keys(Rp),"force, no torque");let o=()=>Rp[r.value()]??{axes:i.map(l=>Number(l.value())),kind:"projection"};return We("Wrench space",r,s,X("div",{class:"buttons"},ke("Show",async()=>{let l=o();if(new Set(l.axes).size<3)return n.notices.error("Choose three different axes.");let c=`wrenches ${++dI}`,u=[];for(let d of cI){let h={...t(),...l,limits:d.limits},f=await n.ask("grasp.wrench_set",h);if(!f)return;u.push(uI(d,f,l.axes,c))}e.replaceChildren(...u)},{id:"show-wrenches"})),e)}var fI=350,Oy=(n,t)=>t?pp(Zx(n,t)):`${pp(n)} (the object's axes)`,Uy=({lower:n,upper:t})=>Number.isFinite(t)?`between ${he(n)} and ${he(t)} (certified)`:`at least ${he(n)} (certified)`;function pI(n,t=null){let{closed:e,epsilon:i,volume:s}=n;if(!e||!i)return[["Grasp",n.reason??n.verdict??"nothing is held"]];let r=[["Force closure",n.force_closure?"\u2713 yes":"\u2717 no: the grasp is unstable"],["Epsilon [N per N]",Uy(i)]];return n.missing_direction&&r.push(["Cannot resist",Oy(n.missing_direction,t)]),n.worst_wrench&&r.push(["Worst disturbance",Oy(n.worst_wrench,t)]),s&&r.push(["Volume [(N per N)\u2076]",Uy(s)]),n.contacts!==void 0&&r.push(["Contacts",String(n.contacts)]),r}function mI({outcome:n,explanation:t,stopped:e=[]}){let i=e.map(({joint:s,by:r})=>`${s}: ${r}`);return[t||n,i.length?`Joints stopped by: ${i.join(", ")}`:""].filter(Boolean).join(`
`)}var gI={Open:"hand.open",Approach:"hand.approach",Close:"hand.close","Auto-grasp":"hand.grasp"},_I=n=>Object.entries(gI).map(([t,e])=>ke(t,n(e),{id:e.replace("hand.","do-"),class:e==="hand.grasp"?"main":null}));function xI(n){let t=Ln("Hand",n),e=Ln("Object",n);return{hand:t,object:e,named:()=>({...t.value()?{hand:t.value()}:{},...e.value()?{object:e.value()}:{}}),fill:r=>{for(let[o,a]of Object.entries({hand:t,object:e})){let l=r.filter(c=>c.kind===o).map(({name:c})=>c);a.set(l),a.hidden=l.length<2}}}}function yI(n,t){let{store:e}=n,i=X("div",{class:"quality",role:"status",id:"quality"}),s=Al("volume too (slower)",!1,()=>u()),r=Al("follow every move",!0,()=>u()),o=()=>h.closest(".page"),a="",l=f=>e.scene.bodies.findIndex(({owner:p})=>p===f),c=()=>e.frame?`${e.frame.revision} ${e.frame.bodies.join()}`:"";async function u(){if(!t.possible())return i.replaceChildren();if(a=c(),!e.frame?.contacts.length&&!s.box.checked)return o().quality=null,i.replaceChildren(X("p",{class:"hint"},"Nothing touches the object."));let f=a,p=await n.ask("grasp.quality",{...t.named(),volume:s.box.checked});if(!p||f!==a)return;o().quality=p,n.picture.vectors.radius(p.torque_scale),e.frame&&n.picture.pose(e.frame),i.classList.toggle("holds",!!p.force_closure);let g=jx(e.frame,l(p.object));i.replaceChildren(ys(pI(p,g)),...tu(p.warnings))}let d=eu(()=>{!o().hidden&&r.box.checked&&c()!==a&&u()},fI),h=We("Quality",i,X("div",{class:"ticks"},r,s),X("div",{class:"buttons"},ke("Find the quality",u,{id:"ask-quality"})));return{element:h,ask:u,soon:d}}function Fy(n){let{store:t}=n,e=xI(()=>l.ask()),{hand:i,object:s,named:r}=e,o=X("p",{class:"outcome",role:"status"}),a=()=>t.scene?.mode==="world",l=yI(n,{named:r,possible:()=>a()&&i.value()&&s.value()&&n.link.connected()}),c=_I(h=>async()=>{let f=await n.ask(h,r());f&&(o.textContent=mI(f),o.textContent&&n.notices.say(o.textContent),await l.ask())}),u=X("div",{class:"page grasp"},i,s,X("div",{class:"buttons"},...c),o,l.element,Ny(n,r),ty(n,r)),d=()=>{e.fill(t.scene?Er(t.scene):[]);let h=!i.value()||!s.value()||!a();c.forEach((f,p)=>f.disabled=p===0?!i.value():h),l.soon()};return t.on(["scene"],d),t.on(["frame","tab"],l.soon),d(),u}var Pp={worlds:{title:"Worlds",verb:"Open",ask:n=>["world.load",{world:n}]},scenes:{title:"Scenes in time",verb:"Open",ask:n=>["motion.open",{scene:n}]},subjects:{title:"Digits with tendons",verb:"Open"},hands:{title:"Hands",verb:"Add",ask:n=>["world.add_hand",{hand:n}]},objects:{title:"Objects",verb:"Add",ask:n=>["world.add_object",{object:n}]}},vI=(n,t)=>{let e=[n.name,n.kind,n.about].join(" ").toLowerCase();return t.toLowerCase().split(/\s+/).every(i=>e.includes(i))},By=({name:n,about:t},e,i)=>X("li",{},De(X("span",{},X("b",{},n),X("span",{class:"about"},t??"")),i,{"aria-label":`${e} ${n}`}));function bI(n){let t=X("ul",{class:"catalogue"});return n.addEventListener("keydown",({key:e})=>{e==="Enter"&&t.querySelector("button")?.click(),e==="ArrowDown"&&t.querySelector("button")?.focus()}),t.addEventListener("keydown",({key:e})=>{let i={ArrowDown:1,ArrowUp:-1}[e];if(!i)return;let s=[...t.querySelectorAll("button")];s[s.indexOf(document.activeElement)+i]?.focus()}),t}function SI(n){let t=new Map;return async e=>{if(!t.has(e)){let i=await n.ask("catalogue.list",{what:e});if(!i)return[];t.set(e,i.entries)}return t.get(e)}}async function wI(n,t,e,i){let r=(await n.ask("catalogue.list",{what:"digits",of:t.name}))?.entries??[],o=l=>{i(),n.ask("tendons.open",{subject:t.name,...l?{digit:l}:{}})};if(r.length<2)return o(r[0]?.name);let a=({name:l,about:c})=>By({name:l,about:c||t.name},"Open",()=>o(l));e.replaceChildren(...r.map(a)),e.querySelector("button").focus()}var MI=n=>Object.entries(Pp).map(([t,{title:e}])=>{let i=De(e,()=>n(t),{class:"kind"});return i.dataset.kind=t,i});function ky(n){let t=SI(n),e=X("input",{type:"search",placeholder:"Search","aria-label":"Search",autocomplete:"off"}),i=bI(e),s=js("open"),r=MI(h),o=()=>l.close(),a=X("div",{class:"dialog-head"},X("h2",{id:s},"Open or add"),De("\xD7",o,{"aria-label":"Close"})),l=X("dialog",{"aria-labelledby":s,class:"open-dialog"},a,X("div",{class:"kinds",role:"group","aria-label":"Kind"},...r),e,i),c="worlds";async function u(f){if(c==="subjects")return wI(n,f,i,o);o();let[p,g]=Pp[c].ask(f.name);c==="worlds"&&!await n.mayLeave()||await n.ask(p,g)}async function d(){let f=c,p=await t(f);if(f!==c)return;let g=p.filter(m=>vI(m,e.value));i.replaceChildren(...g.map(m=>By(m,Pp[f].verb,()=>u(m))),...g.length?[]:[X("li",{class:"hint"},"Nothing has that name.")])}function h(f){c=f;for(let p of r)p.setAttribute("aria-pressed",String(p.dataset.kind===c));d()}return e.addEventListener("input",d),document.body.append(l),f=>{l.showModal(),e.value="",h(f??c),e.focus()}}var EI="uplot",AI="u-hz",TI="u-vt",CI="u-title",RI="u-wrap",PI="u-under",II="u-over",LI="u-axis",oo="u-off",DI="u-select",NI="u-cursor-x",OI="u-cursor-y",UI="u-cursor-pt",FI="u-legend",BI="u-live",kI="u-inline",zI="u-series",GI="u-marker",zy="u-label",VI="u-value",Gl="width",Vl="height";var Gy="bottom",pa="left",Ip="right",Yp="#000",Vy=Yp+"0",Lp="mousemove",Hy="mousedown",Dp="mouseup",Wy="mouseenter",Xy="mouseleave",$y="dblclick",HI="resize",WI="scroll",qy="change",Ou="dppxchange",Zp="--",ba=typeof window<"u",Bp=ba?document:null,ga=ba?window:null,XI=ba?navigator:null,Re,Iu;function kp(){let n=devicePixelRatio;Re!=n&&(Re=n,Iu&&Gp(qy,Iu,kp),Iu=matchMedia(`(min-resolution: ${Re-.001}dppx) and (max-resolution: ${Re+.001}dppx)`),ao(qy,Iu,kp),ga.dispatchEvent(new CustomEvent(Ou)))}function Ri(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function zp(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function sn(n,t,e){n.style[t]=e+"px"}function ns(n,t,e,i){let s=Bp.createElement(n);return t!=null&&Ri(s,t),e?.insertBefore(s,i),s}function Hi(n,t){return ns("div",n,t)}var Yy=new WeakMap;function Es(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Yy.get(n);r!=o&&(n.style.transform=r,Yy.set(n,r),t<0||e<0||t>i||e>s?Ri(n,oo):zp(n,oo))}var Zy=new WeakMap;function jy(n,t,e){let i=t+e,s=Zy.get(n);i!=s&&(Zy.set(n,i),n.style.background=t,n.style.borderColor=e)}var Jy=new WeakMap;function Ky(n,t,e,i){let s=t+""+e,r=Jy.get(n);s!=r&&(Jy.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var jp={passive:!0},$I={...jp,capture:!0};function ao(n,t,e,i){t.addEventListener(n,e,i?$I:jp)}function Gp(n,t,e,i){t.removeEventListener(n,e,jp)}ba&&kp();function is(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Pi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Av(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Tv=n=>n!=null,Cv=n=>n!=null&&n>0,Bu=Av(Tv),qI=Av(Cv);function YI(n,t,e,i=0,s=!1){let r=s?qI:Bu,o=s?Cv:Tv;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??$e,l??-$e]}function ku(n,t,e,i){let s=ev(n),r=ev(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?tr:Rv,a=s==1?Pi:Wi,l=r==1?Wi:Pi,c=a(o(On(n))),u=l(o(On(t))),d=_a(e,c),h=_a(e,u);return e==10&&(c<0&&(d=qe(d,-c)),u<0&&(h=qe(h,-u))),i||e==2?(n=d*s,t=h*r):(n=Dv(n,d),t=zu(t,h)),[n,t]}function Jp(n,t,e,i){let s=ku(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Kp=.1,Qy={mode:3,pad:Kp},Wl={pad:0,soft:null,mode:0},ZI={min:Wl,max:Wl};function Uu(n,t,e,i){return Gu(e)?tv(n,t,e):(Wl.pad=e,Wl.soft=i?0:null,Wl.mode=i?3:0,tv(n,t,ZI))}function Ae(n,t){return n??t}function jI(n,t,e){for(t=Ae(t,0),e=Ae(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function tv(n,t,e){let i=e.min,s=e.max,r=Ae(i.pad,0),o=Ae(s.pad,0),a=Ae(i.hard,-$e),l=Ae(s.hard,$e),c=Ae(i.soft,$e),u=Ae(s.soft,-$e),d=Ae(i.mode,0),h=Ae(s.mode,0),f=t-n,p=tr(f),g=hi(On(n),On(t)),m=tr(g),_=On(m-p);(f<1e-24||_>10)&&(f=0,(n==0||t==0)&&(f=1e-24,d==2&&c!=$e&&(r=0),h==2&&u!=-$e&&(o=0)));let x=f||g||1e3,S=tr(x),y=_a(10,Pi(S)),C=x*(f==0?n==0?.1:1:r),A=qe(Dv(n-C,y/10),24),v=n>=c&&(d==1||d==3&&A<=c||d==2&&A>=c)?c:$e,M=hi(a,A<v&&n>=v?v:ss(v,A)),U=x*(f==0?t==0?.1:1:o),P=qe(zu(t+U,y/10),24),L=t<=u&&(h==1||h==3&&P>=u||h==2&&P<=u)?u:-$e,F=ss(l,P>L&&t<=L?L:hi(L,P));return M==F&&M==0&&(F=100),[M,F]}var JI=new Intl.NumberFormat(ba?XI.language:"en-US"),Qp=n=>JI.format(n),Ii=Math,Nu=Ii.PI,On=Ii.abs,Pi=Ii.floor,Nn=Ii.round,Wi=Ii.ceil,ss=Ii.min,hi=Ii.max,_a=Ii.pow,ev=Ii.sign,tr=Ii.log10,Rv=Ii.log2,KI=(n,t=1)=>Ii.sinh(n)*t,Np=(n,t=1)=>Ii.asinh(n/t),$e=1/0;function nv(n){return(tr((n^n>>31)-(n>>31))|0)+1}function Vp(n,t,e){return ss(hi(n,t),e)}function Pv(n){return typeof n=="function"}function be(n){return Pv(n)?n:()=>n}var QI=()=>{},Iv=n=>n,Lv=(n,t)=>t,t2=n=>null,iv=n=>!0,sv=(n,t)=>n==t,e2=/\.\d*?(?=9{6,}|0{6,})/gm,lo=n=>{if(Ov(n)||Nr.has(n))return n;let t=`${n}`,e=t.match(e2);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${lo(s)}e${r}`}return qe(n,i)};function so(n,t){return lo(qe(lo(n/t))*t)}function zu(n,t){return lo(Wi(lo(n/t))*t)}function Dv(n,t){return lo(Pi(lo(n/t))*t)}function qe(n,t=0){if(Ov(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Nn(i)/e}var Nr=new Map;function Nv(n){return((""+n).split(".")[1]||"").length}function $l(n,t,e,i){let s=[],r=i.map(Nv);for(let o=t;o<e;o++){let a=On(o),l=qe(_a(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:qe(u,d);s.push(h),Nr.set(h,d)}}return s}var Xl={},tm=[],xa=[null,null],Dr=Array.isArray,Ov=Number.isInteger,n2=n=>n===void 0;function rv(n){return typeof n=="string"}function Gu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function i2(n){return n!=null&&typeof n=="object"}var s2=Object.getPrototypeOf(Uint8Array),Uv="__proto__";function ya(n,t=Gu){let e;if(Dr(n)){let i=n.find(s=>s!=null);if(Dr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=ya(n[s],t)}else e=n.slice()}else if(n instanceof s2)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Uv&&(e[i]=ya(n[i],t))}else e=n;return e}function Tn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Uv&&(Gu(n[s])?Tn(n[s],ya(i[s])):n[s]=ya(i[s]))}return n}var r2=0,o2=1,a2=2;function l2(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function c2(n,t){if(d2(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return f2(o[0])||(o=u2(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=t?t[o][c]:o2,f=[];for(let p=0;p<u.length;p++){let g=u[p],m=r.get(l[p]);g===null?h!=r2&&(d[m]=g,h==a2&&f.push(m)):d[m]=g}l2(d,f,s),i.push(d)}}return i}var h2=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function u2(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function d2(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function f2(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=hi(1,Pi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Fv=["January","February","March","April","May","June","July","August","September","October","November","December"],Bv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function kv(n){return n.slice(0,3)}var p2=Bv.map(kv),m2=Fv.map(kv),g2={MMMM:Fv,MMM:m2,WWWW:Bv,WWW:p2};function zl(n){return(n<10?"0":"")+n}function _2(n){return(n<10?"00":n<100?"0":"")+n}var x2={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>zl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>zl(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>zl(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>zl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>zl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>_2(n.getMilliseconds())};function em(n,t){t=t||g2;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?x2[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var y2=new Intl.DateTimeFormat().resolvedOptions().timeZone;function v2(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==y2?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var zv=n=>n%1==0,Fu=[1,2,2.5,5],b2=$l(10,-32,0,Fu),Gv=$l(10,0,32,Fu),S2=Gv.filter(zv),ro=b2.concat(Gv),nm=`
`,Vv="{YYYY}",ov=nm+Vv,Hv="{M}/{D}",Hl=nm+Hv,Lu=Hl+"/{YY}",Wv="{aa}",w2="{h}:{mm}",ma=w2+Wv,av=nm+ma,lv=":{ss}",Ne=null;function Xv(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?$l(10,0,3,Fu).filter(zv):$l(10,-3,0,Fu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Vv,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",ov,Ne,Ne,Ne,Ne,Ne,1],[s,Hv,ov,Ne,Ne,Ne,Ne,Ne,1],[i,"{h}"+Wv,Lu,Ne,Hl,Ne,Ne,Ne,1],[e,ma,Lu,Ne,Hl,Ne,Ne,Ne,1],[t,lv,Lu+" "+ma,Ne,Hl+" "+ma,Ne,av,Ne,1],[n,lv+".{fff}",Lu+" "+ma,Ne,Hl+" "+ma,Ne,av,Ne,1]];function u(d){return(h,f,p,g,m,_)=>{let x=[],S=m>=o,y=m>=r&&m<o,C=d(p),A=qe(C*n,3),v=Op(C.getFullYear(),S?0:C.getMonth(),y||S?1:C.getDate()),M=qe(v*n,3);if(y||S){let U=y?m/r:0,P=S?m/o:0,L=A==M?A:qe(Op(v.getFullYear()+P,v.getMonth()+U,1)*n,3),F=new Date(Nn(L/n)),G=F.getFullYear(),N=F.getMonth();for(let z=0;L<=g;z++){let Y=Op(G+P*z,N+U*z,1),V=Y-d(qe(Y*n,3));L=qe((+Y+V)*n,3),L<=g&&x.push(L)}}else{let U=m>=s?s:m,P=Pi(p)-Pi(A),L=M+P+zu(A-M,U);x.push(L);let F=d(L),G=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,N=m/i,z=h.axes[f]._space,Y=_/z;for(;L=qe(L+m,n==1?0:3),!(L>g);)if(N>1){let V=Pi(qe(G+N,6))%24,K=d(L).getHours()-V;K>1&&(K=-1),L-=K*i,G=(G+N)%24;let et=x[x.length-1];qe((L-et)/m,3)*Y>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,u]}var[M2,E2,A2]=Xv(1),[T2,C2,R2]=Xv(.001);$l(2,-53,53,[1]);function cv(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function hv(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,d,h,f;return i.map(p=>{let g=n(p),m=g.getFullYear(),_=g.getMonth(),x=g.getDate(),S=g.getHours(),y=g.getMinutes(),C=g.getSeconds(),A=m!=l&&a[2]||_!=c&&a[3]||x!=u&&a[4]||S!=d&&a[5]||y!=h&&a[6]||C!=f&&a[7]||a[1];return l=m,c=_,u=x,d=S,h=y,f=C,A(g)})}}function P2(n,t){let e=em(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Op(n,t,e){return new Date(n,t,e)}function uv(n,t){return t(n)}var I2="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function dv(n,t){return(e,i,s,r)=>r==null?Zp:t(n(i))}function L2(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function D2(n,t){return n.series[t].fill(n,t)}var N2={show:!0,live:!0,isolate:!1,mount:QI,markers:{show:!0,width:2,stroke:L2,fill:D2,dash:"solid"},idx:null,idxs:null,values:[]};function O2(n,t){let e=n.cursor.points,i=Hi(),s=e.size(n,t);sn(i,Gl,s),sn(i,Vl,s);let r=s/-2;sn(i,"marginLeft",r),sn(i,"marginTop",r);let o=e.width(n,t,s);return o&&sn(i,"borderWidth",o),i}function U2(n,t){let e=n.series[t].points;return e._fill||e._stroke}function F2(n,t){let e=n.series[t].points;return e._stroke||e._fill}function B2(n,t){return n.series[t].points.size}var Up=[0,0];function k2(n,t,e){return Up[0]=t,Up[1]=e,Up}function Du(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Fp(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var z2={show:!0,x:!0,y:!0,lock:!1,move:k2,points:{one:!1,show:O2,size:B2,width:0,stroke:F2,fill:U2},bind:{mousedown:Du,mouseup:Du,click:Du,dblclick:Du,mousemove:Fp,mouseleave:Fp,mouseenter:Fp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},$v={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},im=Tn({},$v,{filter:Lv}),qv=Tn({},im,{size:10}),Yv=Tn({},$v,{show:!1}),sm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Zv="bold "+sm,jv=1.5,fv={show:!0,scale:"x",stroke:Yp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zv,side:2,grid:im,ticks:qv,border:Yv,font:sm,lineGap:jv,rotate:0},G2="Value",V2="Time",pv={show:!0,scale:"x",auto:!1,sorted:1,min:$e,max:-$e,idxs:[]};function H2(n,t,e,i,s){return t.map(r=>r==null?"":Qp(r))}function W2(n,t,e,i,s,r,o){let a=[],l=Nr.get(s)||0;e=o?e:qe(zu(e,s),l);for(let c=e;c<=i;c=qe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Hp(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?tr:Rv,u=Pi(c(e));s=_a(l,u),l==10&&(s=ro[is(s,ro)]);let d=e,h=s*l;l==10&&(h=ro[is(h,ro)]);do a.push(d),d=d+s,l==10&&!Nr.has(d)&&(d=qe(d,Nr.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=ro[is(h,ro)]));while(d<=i);return a}function X2(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Hp(n,t,hi(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Hp(n,t,hi(l,-i),-e,s):[l]).reverse().map(h=>-h).concat(u,c)}var Jv=/./,$2=/[12357]/,q2=/[125]/,mv=/1/,Wp=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Y2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?Jv:l(7,o)-u>=c?$2:l(5,o)-u>=c?q2:mv;if(d==mv){let h=On(l(1,o)-u);if(h<c)return Wp(t.slice().reverse(),a.distr,d,Wi(c/h)).reverse()}return Wp(t,a.distr,d,1)}function Z2(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=On(l(1,o)-l(2,o));return c<a?Wp(t.slice().reverse(),3,Jv,Wi(a/c)).reverse():t}function j2(n,t,e,i){return i==null?Zp:t==null?"":Qp(t)}var gv={show:!0,scale:"y",stroke:Yp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zv,side:3,grid:im,ticks:qv,border:Yv,font:sm,lineGap:jv,rotate:0};function J2(n,t){let e=3+(n||1)*2;return qe(e*t,3)}function K2(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=On(o-r),l=n.series[t],c=a/(l.points.space*Re);return i[1]-i[0]<=c}var _v={scale:null,auto:!0,sorted:0,min:$e,max:-$e},Kv=(n,t,e,i,s)=>s,xv={show:!0,auto:!0,sorted:0,gaps:Kv,alpha:1,facets:[Tn({},_v,{scale:"x"}),Tn({},_v,{scale:"y"})]},yv={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Kv,alpha:1,points:{show:K2,filter:null},values:null,min:$e,max:-$e,idxs:[],path:null,clip:null};function Q2(n,t,e,i,s){return e/10}var Qv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},t3=Tn({},Qv,{time:!1,ori:1}),vv={};function tb(n,t){let e=vv[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(vv[n]=e)),e}var va=1,Xp=2;function co(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,g=a.height,m=n.valToPosH,_=n.valToPosV;return u.ori==0?e(s,l,c,u,d,m,_,h,f,p,g,Hu,Sa,Xu,nb,sb):e(s,l,c,u,d,_,m,f,h,g,p,Wu,wa,am,ib,rb)}function rm(n,t){let e=0,i=0,s=Ae(n.bands,tm);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function e3(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function er(n,t,e,i,s,r){return co(n,t,(o,a,l,c,u,d,h,f,p,g,m)=>{let _=o.pxRound,x=c.dir*(c.ori==0?1:-1),S=c.ori==0?Sa:wa,y,C;x==1?(y=e,C=i):(y=i,C=e);let A=_(d(a[y],c,g,f)),v=_(h(l[y],u,m,p)),M=_(d(a[C],c,g,f)),U=_(h(r==1?u.max:u.min,u,m,p)),P=new Path2D(s);return S(P,M,U),S(P,A,U),S(P,A,v),P})}function Vu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Xu:am,l=e;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function n3(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function om(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&t[c]===null;)h=c;else for(;--c>=e&&t[c]===null;)h=c;let f=r(n[d]),p=h==d?f:r(n[h]),g=d-s;f=o<=0&&g>=0&&g<l?r(n[g]):f;let _=h+s;p=o>=0&&_>=0&&_<l?r(n[_]):p,p>=f&&a.push([f,p])}return a}function bv(n){return n==0?Iv:n==1?Nn:t=>so(t,n)}function eb(n){let t=n==0?Hu:Wu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=ss(c,a/2,l/2),u=ss(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Hu=(n,t,e)=>{n.moveTo(t,e)},Wu=(n,t,e)=>{n.moveTo(e,t)},Sa=(n,t,e)=>{n.lineTo(t,e)},wa=(n,t,e)=>{n.lineTo(e,t)},Xu=eb(0),am=eb(1),nb=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},ib=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},sb=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},rb=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function ob(n){return(t,e,i,s,r)=>co(t,e,(o,a,l,c,u,d,h,f,p,g,m)=>{let{pxRound:_,points:x}=o,S,y;c.ori==0?(S=Hu,y=nb):(S=Wu,y=ib);let C=qe(x.width*Re,3),A=(x.size-x.width)/2*Re,v=qe(A*2,3),M=new Path2D,U=new Path2D,{left:P,top:L,width:F,height:G}=t.bbox;Xu(U,P-v,L-v,F+v*2,G+v*2);let N=z=>{if(l[z]!=null){let Y=_(d(a[z],c,g,f)),V=_(h(l[z],u,m,p));S(M,Y+A,V),y(M,Y,V,A,0,Nu*2)}};if(r)r.forEach(N);else for(let z=i;z<=s;z++)N(z);return{stroke:C>0?M:null,fill:M,clip:U,flags:va|Xp}})}function ab(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var i3=ab(Sa),s3=ab(wa);function lb(n){let t=Ae(n?.alignGaps,0);return(e,i,s,r)=>co(e,i,(o,a,l,c,u,d,h,f,p,g,m)=>{[s,r]=Bu(l,s,r);let _=o.pxRound,x=G=>_(d(G,c,g,f)),S=G=>_(h(G,u,m,p)),y,C;c.ori==0?(y=Sa,C=i3):(y=wa,C=s3);let A=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:va},M=v.stroke,U=!1;if(r-s>=g*4){let G=ut=>e.posToVal(ut,c.key,!0),N=null,z=null,Y,V,ot,$=x(a[A==1?s:r]),K=x(a[s]),et=x(a[r]),ht=G(A==1?K+1:et-1);for(let ut=A==1?s:r;ut>=s&&ut<=r;ut+=A){let Q=a[ut],yt=(A==1?Q<ht:Q>ht)?$:x(Q),Ct=l[ut];yt==$?Ct!=null?(V=Ct,N==null?(y(M,yt,S(V)),Y=N=z=V):V<N?N=V:V>z&&(z=V)):Ct===null&&(U=!0):(N!=null&&C(M,$,S(N),S(z),S(Y),S(V)),Ct!=null?(V=Ct,y(M,yt,S(V)),N=z=Y=V):(N=z=null,Ct===null&&(U=!0)),$=yt,ht=G($+A))}N!=null&&N!=z&&ot!=$&&C(M,$,S(N),S(z),S(Y),S(V))}else for(let G=A==1?s:r;G>=s&&G<=r;G+=A){let N=l[G];N===null?U=!0:N!=null&&y(M,x(a[G]),S(N))}let[L,F]=rm(e,i);if(o.fill!=null||L!=0){let G=v.fill=new Path2D(M),N=o.fillTo(e,i,o.min,o.max,L),z=S(N),Y=x(a[s]),V=x(a[r]);A==-1&&([V,Y]=[Y,V]),y(G,V,z),y(G,Y,z)}if(!o.spanGaps){let G=[];U&&G.push(...om(a,l,s,r,A,x,t)),v.gaps=G=o.gaps(e,i,s,r,G),v.clip=Vu(G,c.ori,f,p,g,m)}return F!=0&&(v.band=F==2?[er(e,i,s,r,M,-1),er(e,i,s,r,M,1)]:er(e,i,s,r,M,F)),v})}function r3(n){let t=Ae(n.align,1),e=Ae(n.ascDesc,!1),i=Ae(n.alignGaps,0),s=Ae(n.extend,!1);return(r,o,a,l)=>co(r,o,(c,u,d,h,f,p,g,m,_,x,S)=>{[a,l]=Bu(d,a,l);let y=c.pxRound,{left:C,width:A}=r.bbox,v=K=>y(p(K,h,x,m)),M=K=>y(g(K,f,S,_)),U=h.ori==0?Sa:wa,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:va},L=P.stroke,F=h.dir*(h.ori==0?1:-1),G=M(d[F==1?a:l]),N=v(u[F==1?a:l]),z=N,Y=N;s&&t==-1&&(Y=C,U(L,Y,G)),U(L,N,G);for(let K=F==1?a:l;K>=a&&K<=l;K+=F){let et=d[K];if(et==null)continue;let ht=v(u[K]),ut=M(et);t==1?U(L,ht,G):U(L,z,ut),U(L,ht,ut),G=ut,z=ht}let V=z;s&&t==1&&(V=C+A,U(L,V,G));let[ot,$]=rm(r,o);if(c.fill!=null||ot!=0){let K=P.fill=new Path2D(L),et=c.fillTo(r,o,c.min,c.max,ot),ht=M(et);U(K,V,ht),U(K,Y,ht)}if(!c.spanGaps){let K=[];K.push(...om(u,d,a,l,F,v,i));let et=c.width*Re/2,ht=e||t==1?et:-et,ut=e||t==-1?-et:et;K.forEach(Q=>{Q[0]+=ht,Q[1]+=ut}),P.gaps=K=c.gaps(r,o,a,l,K),P.clip=Vu(K,h.ori,m,_,x,S)}return $!=0&&(P.band=$==2?[er(r,o,a,l,L,-1),er(r,o,a,l,L,1)]:er(r,o,a,l,L,$)),P})}function Sv(n,t,e,i,s,r,o=$e){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=On(n[l]-n[a]);u<c&&(c=u,o=On(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function o3(n){n=n||Xl;let t=Ae(n.size,[.6,$e,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=be(s),o=1-t[0],a=Ae(t[1],$e),l=Ae(t[2],1),c=Ae(n.disp,Xl),u=Ae(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,p,g,m)=>co(f,p,(_,x,S,y,C,A,v,M,U,P,L)=>{let F=_.pxRound,G=e,N=i*Re,z=a*Re,Y=l*Re,V,ot;y.ori==0?[V,ot]=r(f,p):[ot,V]=r(f,p);let $=y.dir*(y.ori==0?1:-1),K=y.ori==0?Xu:am,et=y.ori==0?u:(Pt,jt,le,Mt,He,Gt,qt)=>{u(Pt,jt,le,He,Mt,qt,Gt)},ht=Ae(f.bands,tm).find(Pt=>Pt.series[0]==p),ut=ht!=null?ht.dir:0,Q=_.fillTo(f,p,_.min,_.max,ut),gt=F(v(Q,C,L,U)),yt,Ct,wt,Xt=P,ae=F(_.width*Re),Vt=!1,me=null,de=null,re=null,rn=null;d!=null&&(ae==0||h!=null)&&(Vt=!0,me=d.values(f,p,g,m),de=new Map,new Set(me).forEach(Pt=>{Pt!=null&&de.set(Pt,new Path2D)}),ae>0&&(re=h.values(f,p,g,m),rn=new Map,new Set(re).forEach(Pt=>{Pt!=null&&rn.set(Pt,new Path2D)})));let{x0:Ye,size:vn}=c;if(Ye!=null&&vn!=null){G=1,x=Ye.values(f,p,g,m),Ye.unit==2&&(x=x.map(le=>f.posToVal(M+le*P,y.key,!0)));let Pt=vn.values(f,p,g,m);vn.unit==2?Ct=Pt[0]*P:Ct=A(Pt[0],y,P,M)-A(0,y,P,M),Xt=Sv(x,S,A,y,P,M,Xt),wt=Xt-Ct+N}else Xt=Sv(x,S,A,y,P,M,Xt),wt=Xt*o+N,Ct=Xt-wt;wt<1&&(wt=0),ae>=Ct/2&&(ae=0),wt<5&&(F=Iv);let ze=wt>0,Un=Xt-wt-(ze?ae:0);Ct=F(Vp(Un,Y,z)),yt=(G==0?Ct/2:G==$?0:Ct)-G*$*((G==0?N/2:0)+(ze?ae/2:0));let Se={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Cn=Vt?null:new Path2D,dn=null;if(ht!=null)dn=f.data[ht.series[1]];else{let{y0:Pt,y1:jt}=c;Pt!=null&&jt!=null&&(S=jt.values(f,p,g,m),dn=Pt.values(f,p,g,m))}let bn=V*Ct,k=ot*Ct;for(let Pt=$==1?g:m;Pt>=g&&Pt<=m;Pt+=$){let jt=S[Pt];if(jt==null)continue;if(dn!=null){let q=dn[Pt]??0;if(jt-q==0)continue;gt=v(q,C,L,U)}let le=y.distr!=2||c!=null?x[Pt]:Pt,Mt=A(le,y,P,M),He=v(Ae(jt,Q),C,L,U),Gt=F(Mt-yt),qt=F(hi(He,gt)),I=F(ss(He,gt)),w=qt-I;if(jt!=null){let q=jt<0?k:bn,dt=jt<0?bn:k;Vt?(ae>0&&re[Pt]!=null&&K(rn.get(re[Pt]),Gt,I+Pi(ae/2),Ct,hi(0,w-ae),q,dt),me[Pt]!=null&&K(de.get(me[Pt]),Gt,I+Pi(ae/2),Ct,hi(0,w-ae),q,dt)):K(Cn,Gt,I+Pi(ae/2),Ct,hi(0,w-ae),q,dt),et(f,p,Pt,Gt-ae/2,I,Ct+ae,w)}}return ae>0?Se.stroke=Vt?rn:Cn:Vt||(Se._fill=_.width==0?_._fill:_._stroke??_._fill,Se.width=0),Se.fill=Vt?de:Cn,Se})}function a3(n,t){let e=Ae(t?.alignGaps,0);return(i,s,r,o)=>co(i,s,(a,l,c,u,d,h,f,p,g,m,_)=>{[r,o]=Bu(c,r,o);let x=a.pxRound,S=V=>x(h(V,u,m,p)),y=V=>x(f(V,d,_,g)),C,A,v;u.ori==0?(C=Hu,v=Sa,A=sb):(C=Wu,v=wa,A=rb);let M=u.dir*(u.ori==0?1:-1),U=S(l[M==1?r:o]),P=U,L=[],F=[];for(let V=M==1?r:o;V>=r&&V<=o;V+=M)if(c[V]!=null){let $=l[V],K=S($);L.push(P=K),F.push(y(c[V]))}let G={stroke:n(L,F,C,v,A,x),fill:null,clip:null,band:null,gaps:null,flags:va},N=G.stroke,[z,Y]=rm(i,s);if(a.fill!=null||z!=0){let V=G.fill=new Path2D(N),ot=a.fillTo(i,s,a.min,a.max,z),$=y(ot);v(V,P,$),v(V,U,$)}if(!a.spanGaps){let V=[];V.push(...om(l,c,r,o,M,S,e)),G.gaps=V=a.gaps(i,s,r,o,V),G.clip=Vu(V,u.ori,p,g,m,_)}return Y!=0&&(G.band=Y==2?[er(i,s,r,o,N,-1),er(i,s,r,o,N,1)]:er(i,s,r,o,N,Y)),G})}function l3(n){return a3(c3,n)}function c3(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=t[h+1]-t[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,t[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,t[h+1]-l[h+1]*d[h]/3,n[h+1],t[h+1])}return a}var $p=new Set;function wv(){for(let n of $p)n.syncRect(!0)}ba&&(ao(HI,ga,wv),ao(WI,ga,wv,!0),ao(Ou,ga,()=>{qn.pxRatio=Re}));var h3=lb(),u3=ob();function Mv(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>qp(r,o,t,e))}function d3(n,t){return n.map((e,i)=>i==0?{}:Tn({},t,e))}function qp(n,t,e,i){return Tn({},t==0?e:i,n)}function cb(n,t,e){return t==null?xa:[t,e]}var f3=cb;function p3(n,t,e){return t==null?xa:Uu(t,e,Kp,!0)}function hb(n,t,e,i){return t==null?xa:ku(t,e,n.scales[i].log,!1)}var m3=hb;function ub(n,t,e,i){return t==null?xa:Jp(t,e,n.scales[i].log,!1)}var g3=ub;function _3(n,t,e,i,s){let r=hi(nv(n),nv(t)),o=t-n,a=is(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Nr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Ev(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Nn((e=+s)*Re))+"px"),[n,t,e]}function x3(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=qe(t[2]*Re,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function qn(n,t,e){let i={mode:Ae(n.mode,1)},s=i.mode;function r(b,E,D,O){let W=E.valToPct(b);return O+D*(E.dir==-1?1-W:W)}function o(b,E,D,O){let W=E.valToPct(b);return O+D*(E.dir==-1?W:1-W)}function a(b,E,D,O){return E.ori==0?r(b,E,D,O):o(b,E,D,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Hi(EI);if(n.id!=null&&(c.id=n.id),Ri(c,n.class),n.title){let b=Hi(CI,c);b.textContent=n.title}let u=ns("canvas"),d=i.ctx=u.getContext("2d"),h=Hi(RI,c);ao("click",h,b=>{b.target===p&&(Ke!=_o||on!=xo)&&Hn.click(i,b)},!0);let f=i.under=Hi(PI,h);h.appendChild(u);let p=i.over=Hi(II,h);n=ya(n);let g=+Ae(n.pxAlign,1),m=bv(g);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let _=n.ms||.001,x=i.series=s==1?Mv(n.series||[],pv,yv,!1):d3(n.series||[null],xv),S=i.axes=Mv(n.axes||[],fv,gv,!0),y=i.scales={},C=i.bands=n.bands||[];C.forEach(b=>{b.fill=be(b.fill||null),b.dir=Ae(b.dir,-1)});let A=s==2?x[1].facets[0].scale:x[0].scale,v={axes:Is,series:_e},M=(n.drawOrder||["axes","series"]).map(b=>v[b]);function U(b){let E=b.distr==3?D=>tr(D>0?D:b.clamp(i,D,b.min,b.max,b.key)):b.distr==4?D=>Np(D,b.asinh):b.distr==100?D=>b.fwd(D):D=>D;return D=>{let O=E(D),{_min:W,_max:J}=b,lt=J-W;return(O-W)/lt}}function P(b){let E=y[b];if(E==null){let D=(n.scales||Xl)[b]||Xl;if(D.from!=null){P(D.from);let O=Tn({},y[D.from],D,{key:b});O.valToPct=U(O),y[b]=O}else{E=y[b]=Tn({},b==A?Qv:t3,D),E.key=b;let O=E.time,W=E.range,J=Dr(W);if((b!=A||s==2&&!O)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Qy:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Qy:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&Gu(W))){let lt=W;W=(ft,bt,Nt)=>bt==null?xa:Uu(bt,Nt,lt)}E.range=be(W||(O?f3:b==A?E.distr==3?m3:E.distr==4?g3:cb:E.distr==3?hb:E.distr==4?ub:p3)),E.auto=be(J?!1:E.auto),E.clamp=be(E.clamp||Q2),E._min=E._max=null,E.valToPct=U(E)}}}P("x"),P("y"),s==1&&x.forEach(b=>{P(b.scale)}),S.forEach(b=>{P(b.scale)});for(let b in n.scales)P(b);let L=y[A],F=L.distr,G,N;L.ori==0?(Ri(c,AI),G=r,N=o):(Ri(c,TI),G=o,N=r);let z={};for(let b in y){let E=y[b];(E.min!=null||E.max!=null)&&(z[b]={min:E.min,max:E.max},E.min=E.max=null)}let Y=n.tzDate||(b=>new Date(Nn(b/_))),V=n.fmtDate||em,ot=_==1?A2(Y):R2(Y),$=hv(Y,cv(_==1?E2:C2,V)),K=dv(Y,uv(I2,V)),et=[],ht=i.legend=Tn({},N2,n.legend),ut=i.cursor=Tn({},z2,{drag:{y:s==2}},n.cursor),Q=ht.show,gt=ut.show,yt=ht.markers;ht.idxs=et,yt.width=be(yt.width),yt.dash=be(yt.dash),yt.stroke=be(yt.stroke),yt.fill=be(yt.fill);let Ct,wt,Xt,ae=[],Vt=[],me,de=!1,re={};if(ht.live){let b=x[1]?x[1].values:null;de=b!=null,me=de?b(i,1,0):{_:0};for(let E in me)re[E]=Zp}if(Q)if(Ct=ns("table",FI,c),Xt=ns("tbody",null,Ct),ht.mount(i,Ct),de){wt=ns("thead",null,Ct,Xt);let b=ns("tr",null,wt);ns("th",null,b);for(var rn in me)ns("th",zy,b).textContent=rn}else Ri(Ct,kI),ht.live&&Ri(Ct,BI);let Ye={show:!0},vn={show:!1};function ze(b,E){if(E==0&&(de||!ht.live||s==2))return xa;let D=[],O=ns("tr",zI,Xt,Xt.childNodes[E]);Ri(O,b.class),b.show||Ri(O,oo);let W=ns("th",null,O);if(yt.show){let ft=Hi(GI,W);if(E>0){let bt=yt.width(i,E);bt&&(ft.style.border=bt+"px "+yt.dash(i,E)+" "+yt.stroke(i,E)),ft.style.background=yt.fill(i,E)}}let J=Hi(zy,W);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,E>0&&(yt.show||(J.style.color=b.width>0?yt.stroke(i,E):yt.fill(i,E)),Se("click",W,ft=>{if(ut._lock)return;Qt(ft);let bt=x.indexOf(b);if((ft.ctrlKey||ft.metaKey)!=ht.isolate){let Nt=x.some((Ot,Ft)=>Ft>0&&Ft!=bt&&Ot.show);x.forEach((Ot,Ft)=>{Ft>0&&ls(Ft,Nt?Ft==bt?Ye:vn:Ye,!0,En.setSeries)})}else ls(bt,{show:!b.show},!0,En.setSeries)},!1),te&&Se(Wy,W,ft=>{ut._lock||(Qt(ft),ls(x.indexOf(b),vo,!0,En.setSeries))},!1));for(var lt in me){let ft=ns("td",VI,O);ft.textContent="--",D.push(ft)}return[O,D]}let Un=new Map;function Se(b,E,D,O=!0){let W=Un.get(E)||{},J=ut.bind[b](i,E,D,O);J&&(ao(b,E,W[b]=J),Un.set(E,W))}function Cn(b,E,D){let O=Un.get(E)||{};for(let W in O)(b==null||W==b)&&(Gp(W,E,O[W]),delete O[W]);b==null&&Un.delete(E)}let dn=0,bn=0,k=0,Pt=0,jt=0,le=0,Mt=jt,He=le,Gt=k,qt=Pt,I=0,w=0,q=0,dt=0;i.bbox={};let at=!1,xt=!1,vt=!1,nt=!1,st=!1,pt=!1;function B(b,E,D){(D||b!=i.width||E!=i.height)&&rt(b,E),fe(!1),vt=!0,xt=!0,Yn()}function rt(b,E){i.width=dn=k=b,i.height=bn=Pt=E,jt=le=0,St(),Ht();let D=i.bbox;I=D.left=so(jt*Re,.5),w=D.top=so(le*Re,.5),q=D.width=so(k*Re,.5),dt=D.height=so(Pt*Re,.5)}let it=3;function Et(){let b=!1,E=0;for(;!b;){E++;let D=po(E),O=as(E);b=E==it||D&&O,b||(rt(i.width,i.height),xt=!0)}}function _t({width:b,height:E}){B(b,E)}i.setSize=_t;function St(){let b=!1,E=!1,D=!1,O=!1;S.forEach((W,J)=>{if(W.show&&W._show){let{side:lt,_size:ft}=W,bt=lt%2,Nt=W.label!=null?W.labelSize:0,Ot=ft+Nt;Ot>0&&(bt?(k-=Ot,lt==3?(jt+=Ot,O=!0):D=!0):(Pt-=Ot,lt==0?(le+=Ot,b=!0):E=!0))}}),rs[0]=b,rs[1]=D,rs[2]=E,rs[3]=O,k-=Xi[1]+Xi[3],jt+=Xi[3],Pt-=Xi[2]+Xi[0],le+=Xi[0]}function Ht(){let b=jt+k,E=le+Pt,D=jt,O=le;function W(J,lt){switch(J){case 1:return b+=lt,b-lt;case 2:return E+=lt,E-lt;case 3:return D-=lt,D+lt;case 0:return O-=lt,O+lt}}S.forEach((J,lt)=>{if(J.show&&J._show){let ft=J.side;J._pos=W(ft,J._size),J.label!=null&&(J._lpos=W(ft,J.labelSize))}})}if(ut.dataIdx==null){let b=ut.hover,E=b.skip=new Set(b.skip??[]);E.add(void 0);let D=b.prox=be(b.prox),O=b.bias??(b.bias=0);ut.dataIdx=(W,J,lt,ft)=>{if(J==0)return lt;let bt=lt,Nt=D(W,J,lt,ft)??$e,Ot=Nt>=0&&Nt<$e,Ft=L.ori==0?k:Pt,oe=ut.left,Te=t[0],Me=t[J];if(E.has(Me[lt])){bt=null;let xe=null,Jt=null,$t;if(O==0||O==-1)for($t=lt;xe==null&&$t-- >0;)E.has(Me[$t])||(xe=$t);if(O==0||O==1)for($t=lt;Jt==null&&$t++<Me.length;)E.has(Me[$t])||(Jt=$t);if(xe!=null||Jt!=null)if(Ot){let tn=xe==null?-1/0:G(Te[xe],L,Ft,0),mn=Jt==null?1/0:G(Te[Jt],L,Ft,0),zn=oe-tn,Ge=mn-oe;zn<=Ge?zn<=Nt&&(bt=xe):Ge<=Nt&&(bt=Jt)}else bt=Jt==null?xe:xe==null?Jt:lt-xe<=Jt-lt?xe:Jt}else Ot&&On(oe-G(Te[lt],L,Ft,0))>Nt&&(bt=null);return bt}}let Qt=b=>{ut.event=b};ut.idxs=et,ut._lock=!1;let ct=ut.points;ct.show=be(ct.show),ct.size=be(ct.size),ct.stroke=be(ct.stroke),ct.width=be(ct.width),ct.fill=be(ct.fill);let Bt=i.focus=Tn({},n.focus||{alpha:.3},ut.focus),te=Bt.prox>=0,Rt=te&&ct.one,ue=[],Je=[],Qn=[];function Ma(b,E){let D=ct.show(i,E);if(D instanceof HTMLElement)return Ri(D,UI),Ri(D,b.class),Es(D,-10,-10,k,Pt),p.insertBefore(D,ue[E]),D}function ho(b,E){if(s==1||E>0){let D=s==1&&y[b.scale].time,O=b.value;b.value=D?rv(O)?dv(Y,uv(O,V)):O||K:O||j2,b.label=b.label||(D?V2:G2)}if(Rt||E>0){b.width=b.width==null?1:b.width,b.paths=b.paths||h3||t2,b.fillTo=be(b.fillTo||e3),b.pxAlign=+Ae(b.pxAlign,g),b.pxRound=bv(b.pxAlign),b.stroke=be(b.stroke||null),b.fill=be(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let D=J2(hi(1,b.width),1),O=b.points=Tn({},{size:D,width:hi(1,D*.2),stroke:b.stroke,space:D*2,paths:u3,_stroke:null,_fill:null},b.points);O.show=be(O.show),O.filter=be(O.filter),O.fill=be(O.fill),O.stroke=be(O.stroke),O.paths=be(O.paths),O.pxAlign=b.pxAlign}if(Q){let D=ze(b,E);ae.splice(E,0,D[0]),Vt.splice(E,0,D[1]),ht.values.push(null)}if(gt){et.splice(E,0,null);let D=null;Rt?E==0&&(D=Ma(b,E)):E>0&&(D=Ma(b,E)),ue.splice(E,0,D),Je.splice(E,0,0),Qn.splice(E,0,0)}kn("addSeries",E)}function Zu(b,E){E=E??x.length,b=s==1?qp(b,E,pv,yv):qp(b,E,{},xv),x.splice(E,0,b),ho(x[E],E)}i.addSeries=Zu;function ql(b){if(x.splice(b,1),Q){ht.values.splice(b,1),Vt.splice(b,1);let E=ae.splice(b,1)[0];Cn(null,E.firstChild),E.remove()}gt&&(et.splice(b,1),ue.splice(b,1)[0].remove(),Je.splice(b,1),Qn.splice(b,1)),kn("delSeries",b)}i.delSeries=ql;let rs=[!1,!1,!1,!1];function Cs(b,E){if(b._show=b.show,b.show){let D=b.side%2,O=y[b.scale];O==null&&(b.scale=D?x[1].scale:A,O=y[b.scale]);let W=O.time;b.size=be(b.size),b.space=be(b.space),b.rotate=be(b.rotate),Dr(b.incrs)&&b.incrs.forEach(lt=>{!Nr.has(lt)&&Nr.set(lt,Nv(lt))}),b.incrs=be(b.incrs||(O.distr==2?S2:W?_==1?M2:T2:ro)),b.splits=be(b.splits||(W&&O.distr==1?ot:O.distr==3?Hp:O.distr==4?X2:W2)),b.stroke=be(b.stroke),b.grid.stroke=be(b.grid.stroke),b.ticks.stroke=be(b.ticks.stroke),b.border.stroke=be(b.border.stroke);let J=b.values;b.values=Dr(J)&&!Dr(J[0])?be(J):W?Dr(J)?hv(Y,cv(J,V)):rv(J)?P2(Y,J):J||$:J||H2,b.filter=be(b.filter||(O.distr>=3&&O.log==10?Y2:O.distr==3&&O.log==2?Z2:Lv)),b.font=Ev(b.font),b.labelFont=Ev(b.labelFont),b._size=b.size(i,null,E,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(rs[E]=!0,b._el=Hi(LI,h))}}function Rs(b,E,D,O){let[W,J,lt,ft]=D,bt=E%2,Nt=0;return bt==0&&(ft||J)&&(Nt=E==0&&!W||E==2&&!lt?Nn(fv.size/3):0),bt==1&&(W||lt)&&(Nt=E==1&&!J||E==3&&!ft?Nn(gv.size/2):0),Nt}let Ea=i.padding=(n.padding||[Rs,Rs,Rs,Rs]).map(b=>be(Ae(b,Rs))),Xi=i._padding=Ea.map((b,E)=>b(i,E,rs,0)),fn,xn=null,yn=null,os=s==1?x[0].idxs:null,mi=null,nr=!1;function Aa(b,E){if(t=b??[],i.data=i._data=t,s==2){fn=0;for(let D=1;D<x.length;D++)fn+=t[D][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),mi=t[0],fn=mi.length;let D=t;if(F==2){D=t.slice();let O=D[0]=Array(fn);for(let W=0;W<fn;W++)O[W]=W}i._data=t=D}if(fe(!0),kn("setData"),F==2&&(vt=!0),E!==!1){let D=L;D.auto(i,nr)?Ta():rr(A,D.min,D.max),nt=nt||ut.left>=0,pt=!0,Yn()}}i.setData=Aa;function Ta(){nr=!0;let b,E;s==1&&(fn>0?(xn=os[0]=0,yn=os[1]=fn-1,b=t[0][xn],E=t[0][yn],F==2?(b=xn,E=yn):b==E&&(F==3?[b,E]=ku(b,b,L.log,!1):F==4?[b,E]=Jp(b,b,L.log,!1):L.time?E=b+Nn(86400/_):[b,E]=Uu(b,E,Kp,!0))):(xn=os[0]=b=null,yn=os[1]=E=null)),rr(A,b,E)}let uo,ir,fo,T,H,tt,Z,j,At,Lt;function Tt(b,E,D,O,W,J){b??(b=Vy),D??(D=tm),O??(O="butt"),W??(W=Vy),J??(J="round"),b!=uo&&(d.strokeStyle=uo=b),W!=ir&&(d.fillStyle=ir=W),E!=fo&&(d.lineWidth=fo=E),J!=H&&(d.lineJoin=H=J),O!=tt&&(d.lineCap=tt=O),D!=T&&d.setLineDash(T=D)}function Dt(b,E,D,O){E!=ir&&(d.fillStyle=ir=E),b!=Z&&(d.font=Z=b),D!=j&&(d.textAlign=j=D),O!=At&&(d.textBaseline=At=O)}function zt(b,E,D,O,W=0){if(O.length>0&&b.auto(i,nr)&&(E==null||E.min==null)){let J=Ae(xn,0),lt=Ae(yn,O.length-1),ft=D.min==null?YI(O,J,lt,W,b.distr==3):[D.min,D.max];b.min=ss(b.min,D.min=ft[0]),b.max=hi(b.max,D.max=ft[1])}}let ne={min:null,max:null};function ge(){for(let O in y){let W=y[O];z[O]==null&&(W.min==null||z[A]!=null&&W.auto(i,nr))&&(z[O]=ne)}for(let O in y){let W=y[O];z[O]==null&&W.from!=null&&z[W.from]!=null&&(z[O]=ne)}z[A]!=null&&fe(!0);let b={};for(let O in z){let W=z[O];if(W!=null){let J=b[O]=ya(y[O],i2);if(W.min!=null)Tn(J,W);else if(O!=A||s==2)if(fn==0&&J.from==null){let lt=J.range(i,null,null,O);J.min=lt[0],J.max=lt[1]}else J.min=$e,J.max=-$e}}if(fn>0){x.forEach((O,W)=>{if(s==1){let J=O.scale,lt=z[J];if(lt==null)return;let ft=b[J];if(W==0){let bt=ft.range(i,ft.min,ft.max,J);ft.min=bt[0],ft.max=bt[1],xn=is(ft.min,t[0]),yn=is(ft.max,t[0]),yn-xn>1&&(t[0][xn]<ft.min&&xn++,t[0][yn]>ft.max&&yn--),O.min=mi[xn],O.max=mi[yn]}else O.show&&O.auto&&zt(ft,lt,O,t[W],O.sorted);O.idxs[0]=xn,O.idxs[1]=yn}else if(W>0&&O.show&&O.auto){let[J,lt]=O.facets,ft=J.scale,bt=lt.scale,[Nt,Ot]=t[W],Ft=b[ft],oe=b[bt];Ft!=null&&zt(Ft,z[ft],J,Nt,J.sorted),oe!=null&&zt(oe,z[bt],lt,Ot,lt.sorted),O.min=lt.min,O.max=lt.max}});for(let O in b){let W=b[O],J=z[O];if(W.from==null&&(J==null||J.min==null)){let lt=W.range(i,W.min==$e?null:W.min,W.max==-$e?null:W.max,O);W.min=lt[0],W.max=lt[1]}}}for(let O in b){let W=b[O];if(W.from!=null){let J=b[W.from];if(J.min==null)W.min=W.max=null;else{let lt=W.range(i,J.min,J.max,O);W.min=lt[0],W.max=lt[1]}}}let E={},D=!1;for(let O in b){let W=b[O],J=y[O];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let lt=J.distr;J._min=lt==3?tr(J.min):lt==4?Np(J.min,J.asinh):lt==100?J.fwd(J.min):J.min,J._max=lt==3?tr(J.max):lt==4?Np(J.max,J.asinh):lt==100?J.fwd(J.max):J.max,E[O]=D=!0}}if(D){x.forEach((O,W)=>{s==2?W>0&&E.y&&(O._paths=null):E[O.scale]&&(O._paths=null)});for(let O in E)vt=!0,kn("setScale",O);gt&&ut.left>=0&&(nt=pt=!0)}for(let O in z)z[O]=null}function kt(b){let E=Vp(xn-1,0,fn-1),D=Vp(yn+1,0,fn-1);for(;b[E]==null&&E>0;)E--;for(;b[D]==null&&D<fn-1;)D++;return[E,D]}function _e(){if(fn>0){let b=x.some(E=>E._focus)&&Lt!=Bt.alpha;b&&(d.globalAlpha=Lt=Bt.alpha),x.forEach((E,D)=>{if(D>0&&E.show&&(cn(D,!1),cn(D,!0),E._paths==null)){let O=Lt;Lt!=E.alpha&&(d.globalAlpha=Lt=E.alpha);let W=s==2?[0,t[D][0].length-1]:kt(t[D]);E._paths=E.paths(i,D,W[0],W[1]),Lt!=O&&(d.globalAlpha=Lt=O)}}),x.forEach((E,D)=>{if(D>0&&E.show){let O=Lt;Lt!=E.alpha&&(d.globalAlpha=Lt=E.alpha),E._paths!=null&&Oe(D,!1);{let W=E._paths!=null?E._paths.gaps:null,J=E.points.show(i,D,xn,yn,W),lt=E.points.filter(i,D,J,W);(J||lt)&&(E.points._paths=E.points.paths(i,D,xn,yn,lt),Oe(D,!0))}Lt!=O&&(d.globalAlpha=Lt=O),kn("drawSeries",D)}}),b&&(d.globalAlpha=Lt=1)}}function cn(b,E){let D=E?x[b].points:x[b];D._stroke=D.stroke(i,b),D._fill=D.fill(i,b)}function Oe(b,E){let D=E?x[b].points:x[b],{stroke:O,fill:W,clip:J,flags:lt,_stroke:ft=D._stroke,_fill:bt=D._fill,_width:Nt=D.width}=D._paths;Nt=qe(Nt*Re,3);let Ot=null,Ft=Nt%2/2;E&&bt==null&&(bt=Nt>0?"#fff":ft);let oe=D.pxAlign==1&&Ft>0;if(oe&&d.translate(Ft,Ft),!E){let Te=I-Nt/2,Me=w-Nt/2,xe=q+Nt,Jt=dt+Nt;Ot=new Path2D,Ot.rect(Te,Me,xe,Jt)}E?Ut(ft,Nt,D.dash,D.cap,bt,O,W,lt,J):Ue(b,ft,Nt,D.dash,D.cap,bt,O,W,lt,Ot,J),oe&&d.translate(-Ft,-Ft)}function Ue(b,E,D,O,W,J,lt,ft,bt,Nt,Ot){let Ft=!1;bt!=0&&C.forEach((oe,Te)=>{if(oe.series[0]==b){let Me=x[oe.series[1]],xe=t[oe.series[1]],Jt=(Me._paths||Xl).band;Dr(Jt)&&(Jt=oe.dir==1?Jt[0]:Jt[1]);let $t,tn=null;Me.show&&Jt&&jI(xe,xn,yn)?(tn=oe.fill(i,Te)||J,$t=Me._paths.clip):Jt=null,Ut(E,D,O,W,tn,lt,ft,bt,Nt,Ot,$t,Jt),Ft=!0}}),Ft||Ut(E,D,O,W,J,lt,ft,bt,Nt,Ot)}let Rn=va|Xp;function Ut(b,E,D,O,W,J,lt,ft,bt,Nt,Ot,Ft){Tt(b,E,D,O,W),(bt||Nt||Ft)&&(d.save(),bt&&d.clip(bt),Nt&&d.clip(Nt)),Ft?(ft&Rn)==Rn?(d.clip(Ft),Ot&&d.clip(Ot),ye(W,lt),Sn(b,J,E)):ft&Xp?(ye(W,lt),d.clip(Ft),Sn(b,J,E)):ft&va&&(d.save(),d.clip(Ft),Ot&&d.clip(Ot),ye(W,lt),d.restore(),Sn(b,J,E)):(ye(W,lt),Sn(b,J,E)),(bt||Nt||Ft)&&d.restore()}function Sn(b,E,D){D>0&&(E instanceof Map?E.forEach((O,W)=>{d.strokeStyle=uo=W,d.stroke(O)}):E!=null&&b&&d.stroke(E))}function ye(b,E){E instanceof Map?E.forEach((D,O)=>{d.fillStyle=ir=O,d.fill(D)}):E!=null&&b&&d.fill(E)}function Ps(b,E,D,O){let W=S[b],J;if(O<=0)J=[0,0];else{let lt=W._space=W.space(i,b,E,D,O),ft=W._incrs=W.incrs(i,b,E,D,O,lt);J=_3(E,D,ft,O,lt)}return W._found=J}function wn(b,E,D,O,W,J,lt,ft,bt,Nt){let Ot=lt%2/2;g==1&&d.translate(Ot,Ot),Tt(ft,lt,bt,Nt,ft),d.beginPath();let Ft,oe,Te,Me,xe=W+(O==0||O==3?-J:J);D==0?(oe=W,Me=xe):(Ft=W,Te=xe);for(let Jt=0;Jt<b.length;Jt++)E[Jt]!=null&&(D==0?Ft=Te=b[Jt]:oe=Me=b[Jt],d.moveTo(Ft,oe),d.lineTo(Te,Me));d.stroke(),g==1&&d.translate(-Ot,-Ot)}function po(b){let E=!0;return S.forEach((D,O)=>{if(!D.show)return;let W=y[D.scale];if(W.min==null){D._show&&(E=!1,D._show=!1,fe(!1));return}else D._show||(E=!1,D._show=!0,fe(!1));let J=D.side,lt=J%2,{min:ft,max:bt}=W,[Nt,Ot]=Ps(O,ft,bt,lt==0?k:Pt);if(Ot==0)return;let Ft=W.distr==2,oe=D._splits=D.splits(i,O,ft,bt,Nt,Ot,Ft),Te=W.distr==2?oe.map($t=>mi[$t]):oe,Me=W.distr==2?mi[oe[1]]-mi[oe[0]]:Nt,xe=D._values=D.values(i,D.filter(i,Te,O,Ot,Me),O,Ot,Me);D._rotate=J==2?D.rotate(i,xe,O,Ot):0;let Jt=D._size;D._size=Wi(D.size(i,xe,O,b)),Jt!=null&&D._size!=Jt&&(E=!1)}),E}function as(b){let E=!0;return Ea.forEach((D,O)=>{let W=D(i,O,rs,b);W!=Xi[O]&&(E=!1),Xi[O]=W}),E}function Is(){for(let b=0;b<S.length;b++){let E=S[b];if(!E.show||!E._show)continue;let D=E.side,O=D%2,W,J,lt=E.stroke(i,b),ft=D==0||D==3?-1:1,[bt,Nt]=E._found;if(E.label!=null){let ni=E.labelGap*ft,xi=Nn((E._lpos+ni)*Re);Dt(E.labelFont[0],lt,"center",D==2?"top":Gy),d.save(),O==1?(W=J=0,d.translate(xi,Nn(w+dt/2)),d.rotate((D==3?-Nu:Nu)/2)):(W=Nn(I+q/2),J=xi);let Fr=Pv(E.label)?E.label(i,b,bt,Nt):E.label;d.fillText(Fr,W,J),d.restore()}if(Nt==0)continue;let Ot=y[E.scale],Ft=O==0?q:dt,oe=O==0?I:w,Te=E._splits,Me=Ot.distr==2?Te.map(ni=>mi[ni]):Te,xe=Ot.distr==2?mi[Te[1]]-mi[Te[0]]:bt,Jt=E.ticks,$t=E.border,tn=Jt.show?Jt.size:0,mn=Nn(tn*Re),zn=Nn((E.alignTo==2?E._size-tn-E.gap:E.gap)*Re),Ge=E._rotate*-Nu/180,gn=m(E._pos*Re),gi=(mn+zn)*ft,ei=gn+gi;J=O==0?ei:0,W=O==1?ei:0;let Li=E.font[0],$i=E.align==1?pa:E.align==2?Ip:Ge>0?pa:Ge<0?Ip:O==0?"center":D==3?Ip:pa,hs=Ge||O==1?"middle":D==2?"top":Gy;Dt(Li,lt,$i,hs);let _i=E.font[1]*E.lineGap,Di=Te.map(ni=>m(a(ni,Ot,Ft,oe))),qi=E._values;for(let ni=0;ni<qi.length;ni++){let xi=qi[ni];if(xi!=null){O==0?W=Di[ni]:J=Di[ni],xi=""+xi;let Fr=xi.indexOf(`
`)==-1?[xi]:xi.split(/\n/gm);for(let ii=0;ii<Fr.length;ii++){let Nm=Fr[ii];Ge?(d.save(),d.translate(W,J+ii*_i),d.rotate(Ge),d.fillText(Nm,0,0),d.restore()):d.fillText(Nm,W,J+ii*_i)}}}Jt.show&&wn(Di,Jt.filter(i,Me,b,Nt,xe),O,D,gn,mn,qe(Jt.width*Re,3),Jt.stroke(i,b),Jt.dash,Jt.cap);let us=E.grid;us.show&&wn(Di,us.filter(i,Me,b,Nt,xe),O,O==0?2:1,O==0?w:I,O==0?dt:q,qe(us.width*Re,3),us.stroke(i,b),us.dash,us.cap),$t.show&&wn([gn],[1],O==0?1:0,O==0?1:2,O==1?w:I,O==1?dt:q,qe($t.width*Re,3),$t.stroke(i,b),$t.dash,$t.cap)}kn("drawAxes")}function fe(b){x.forEach((E,D)=>{D>0&&(E._paths=null,b&&(s==1?(E.min=null,E.max=null):E.facets.forEach(O=>{O.min=null,O.max=null})))})}let pn=!1,ti=!1,Fe=[];function Mn(){ti=!1;for(let b=0;b<Fe.length;b++)kn(...Fe[b]);Fe.length=0}function Yn(){pn||(h2(gm),pn=!0)}function Yl(b,E=!1){pn=!0,ti=E,b(i),gm(),E&&Fe.length>0&&queueMicrotask(Mn)}i.batch=Yl;function gm(){if(at&&(ge(),at=!1),vt&&(Et(),vt=!1),xt){if(sn(f,pa,jt),sn(f,"top",le),sn(f,Gl,k),sn(f,Vl,Pt),sn(p,pa,jt),sn(p,"top",le),sn(p,Gl,k),sn(p,Vl,Pt),sn(h,Gl,dn),sn(h,Vl,bn),u.width=Nn(dn*Re),u.height=Nn(bn*Re),S.forEach(({_el:b,_show:E,_size:D,_pos:O,side:W})=>{if(b!=null)if(E){let J=W===3||W===0?D:0,lt=W%2==1;sn(b,lt?"left":"top",O-J),sn(b,lt?"width":"height",D),sn(b,lt?"top":"left",lt?le:jt),sn(b,lt?"height":"width",lt?Pt:k),zp(b,oo)}else Ri(b,oo)}),uo=ir=fo=H=tt=Z=j=At=T=null,Lt=1,Pa(!0),jt!=Mt||le!=He||k!=Gt||Pt!=qt){fe(!1);let b=k/Gt,E=Pt/qt;if(gt&&!nt&&ut.left>=0){ut.left*=b,ut.top*=E,mo&&Es(mo,Nn(ut.left),0,k,Pt),go&&Es(go,0,Nn(ut.top),k,Pt);for(let D=0;D<ue.length;D++){let O=ue[D];O!=null&&(Je[D]*=b,Qn[D]*=E,Es(O,Wi(Je[D]),Wi(Qn[D]),k,Pt))}}if(Qe.show&&!st&&Qe.left>=0&&Qe.width>0){Qe.left*=b,Qe.width*=b,Qe.top*=E,Qe.height*=E;for(let D in ed)sn(yo,D,Qe[D])}Mt=jt,He=le,Gt=k,qt=Pt}kn("setSize"),xt=!1}dn>0&&bn>0&&(d.clearRect(0,0,u.width,u.height),kn("drawClear"),M.forEach(b=>b()),kn("draw")),Qe.show&&st&&(Zl(Qe),st=!1),gt&&nt&&(Ur(null,!0,!1),nt=!1),ht.show&&ht.live&&pt&&(Qu(),pt=!1),l||(l=!0,i.status=1,kn("ready")),nr=!1,pn=!1}i.redraw=(b,E)=>{vt=E||!1,b!==!1?rr(A,L.min,L.max):Yn()};function ju(b,E){let D=y[b];if(D.from==null){if(fn==0){let O=D.range(i,E.min,E.max,b);E.min=O[0],E.max=O[1]}if(E.min>E.max){let O=E.min;E.min=E.max,E.max=O}if(fn>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;b==A&&D.distr==2&&fn>0&&(E.min=is(E.min,t[0]),E.max=is(E.max,t[0]),E.min==E.max&&E.max++),z[b]=E,at=!0,Yn()}}i.setScale=ju;let Ju,Ku,mo,go,_m,xm,_o,xo,ym,vm,Ke,on,sr=!1,Hn=ut.drag,Fn=Hn.x,Bn=Hn.y;gt&&(ut.x&&(Ju=Hi(NI,p)),ut.y&&(Ku=Hi(OI,p)),L.ori==0?(mo=Ju,go=Ku):(mo=Ku,go=Ju),Ke=ut.left,on=ut.top);let Qe=i.select=Tn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),yo=Qe.show?Hi(DI,Qe.over?p:f):null;function Zl(b,E){if(Qe.show){for(let D in b)Qe[D]=b[D],D in ed&&sn(yo,D,b[D]);E!==!1&&kn("setSelect")}}i.setSelect=Zl;function tS(b){if(x[b].show)Q&&zp(ae[b],oo);else if(Q&&Ri(ae[b],oo),gt){let D=Rt?ue[0]:ue[b];D!=null&&Es(D,-10,-10,k,Pt)}}function rr(b,E,D){ju(b,{min:E,max:D})}function ls(b,E,D,O){E.focus!=null&&rS(b),E.show!=null&&x.forEach((W,J)=>{J>0&&(b==J||b==null)&&(W.show=E.show,tS(J),s==2?(rr(W.facets[0].scale,null,null),rr(W.facets[1].scale,null,null)):rr(W.scale,null,null),Yn())}),D!==!1&&kn("setSeries",b,E),O&&Ia("setSeries",i,b,E)}i.setSeries=ls;function eS(b,E){Tn(C[b],E)}function nS(b,E){b.fill=be(b.fill||null),b.dir=Ae(b.dir,-1),E=E??C.length,C.splice(E,0,b)}function iS(b){b==null?C.length=0:C.splice(b,1)}i.addBand=nS,i.setBand=eS,i.delBand=iS;function sS(b,E){x[b].alpha=E,gt&&ue[b]!=null&&(ue[b].style.opacity=E),Q&&ae[b]&&(ae[b].style.opacity=E)}let Ls,or,Or,vo={focus:!0};function rS(b){if(b!=Or){let E=b==null,D=Bt.alpha!=1;x.forEach((O,W)=>{if(s==1||W>0){let J=E||W==0||W==b;O._focus=E?null:J,D&&sS(W,J?1:Bt.alpha)}}),Or=b,D&&Yn()}}Q&&te&&Se(Xy,Ct,b=>{ut._lock||(Qt(b),Or!=null&&ls(null,vo,!0,En.setSeries))});function cs(b,E,D){let O=y[E];D&&(b=b/Re-(O.ori==1?le:jt));let W=k;O.ori==1&&(W=Pt,b=W-b),O.dir==-1&&(b=W-b);let J=O._min,lt=O._max,ft=b/W,bt=J+(lt-J)*ft,Nt=O.distr;return Nt==3?_a(10,bt):Nt==4?KI(bt,O.asinh):Nt==100?O.bwd(bt):bt}function oS(b,E){let D=cs(b,A,E);return is(D,t[0],xn,yn)}i.valToIdx=b=>is(b,t[0]),i.posToIdx=oS,i.posToVal=cs,i.valToPos=(b,E,D)=>y[E].ori==0?r(b,y[E],D?q:k,D?I:0):o(b,y[E],D?dt:Pt,D?w:0),i.setCursor=(b,E,D)=>{Ke=b.left,on=b.top,Ur(null,E,D)};function bm(b,E){sn(yo,pa,Qe.left=b),sn(yo,Gl,Qe.width=E)}function Sm(b,E){sn(yo,"top",Qe.top=b),sn(yo,Vl,Qe.height=E)}let Ca=L.ori==0?bm:Sm,Ra=L.ori==1?bm:Sm;function aS(){if(Q&&ht.live)for(let b=s==2?1:0;b<x.length;b++){if(b==0&&de)continue;let E=ht.values[b],D=0;for(let O in E)Vt[b][D++].firstChild.nodeValue=E[O]}}function Qu(b,E){if(b!=null&&(b.idxs?b.idxs.forEach((D,O)=>{et[O]=D}):n2(b.idx)||et.fill(b.idx),ht.idx=et[0]),Q&&ht.live){for(let D=0;D<x.length;D++)(D>0||s==1&&!de)&&lS(D,et[D]);aS()}pt=!1,E!==!1&&kn("setLegend")}i.setLegend=Qu;function lS(b,E){let D=x[b],O=b==0&&F==2?mi:t[b],W;de?W=D.values(i,b,E)??re:(W=D.value(i,E==null?null:O[E],b,E),W=W==null?re:{_:W}),ht.values[b]=W}function Ur(b,E,D){ym=Ke,vm=on,[Ke,on]=ut.move(i,Ke,on),ut.left=Ke,ut.top=on,gt&&(mo&&Es(mo,Nn(Ke),0,k,Pt),go&&Es(go,0,Nn(on),k,Pt));let O,W=xn>yn;Ls=$e,or=null;let J=L.ori==0?k:Pt,lt=L.ori==1?k:Pt;if(Ke<0||fn==0||W){O=ut.idx=null;for(let ft=0;ft<x.length;ft++){let bt=ue[ft];bt!=null&&Es(bt,-10,-10,k,Pt)}te&&ls(null,vo,!0,b==null&&En.setSeries),ht.live&&(et.fill(O),pt=!0)}else{let ft,bt,Nt;s==1&&(ft=L.ori==0?Ke:on,bt=cs(ft,A),O=ut.idx=is(bt,t[0],xn,yn),Nt=G(t[0][O],L,J,0));let Ot=-10,Ft=-10,oe=0,Te=0,Me=!0,xe="",Jt="";for(let $t=s==2?1:0;$t<x.length;$t++){let tn=x[$t],mn=et[$t],zn=mn==null?null:s==1?t[$t][mn]:t[$t][1][mn],Ge=ut.dataIdx(i,$t,O,bt),gn=Ge==null?null:s==1?t[$t][Ge]:t[$t][1][Ge];if(pt=pt||gn!=zn||Ge!=mn,et[$t]=Ge,$t>0&&tn.show){let gi=Ge==null?-10:Ge==O?Nt:G(s==1?t[0][Ge]:t[$t][0][Ge],L,J,0),ei=gn==null?-10:N(gn,s==1?y[tn.scale]:y[tn.facets[1].scale],lt,0);if(te&&gn!=null){let Li=L.ori==1?Ke:on,$i=On(Bt.dist(i,$t,Ge,ei,Li));if($i<Ls){let hs=Bt.bias;if(hs!=0){let _i=cs(Li,tn.scale),Di=gn>=0?1:-1,qi=_i>=0?1:-1;qi==Di&&(qi==1?hs==1?gn>=_i:gn<=_i:hs==1?gn<=_i:gn>=_i)&&(Ls=$i,or=$t)}else Ls=$i,or=$t}}if(pt||Rt){let Li,$i;L.ori==0?(Li=gi,$i=ei):(Li=ei,$i=gi);let hs,_i,Di,qi,us,ni,xi=!0,Fr=ct.bbox;if(Fr!=null){xi=!1;let ii=Fr(i,$t);Di=ii.left,qi=ii.top,hs=ii.width,_i=ii.height}else Di=Li,qi=$i,hs=_i=ct.size(i,$t);if(ni=ct.fill(i,$t),us=ct.stroke(i,$t),Rt)$t==or&&Ls<=Bt.prox&&(Ot=Di,Ft=qi,oe=hs,Te=_i,Me=xi,xe=ni,Jt=us);else{let ii=ue[$t];ii!=null&&(Je[$t]=Di,Qn[$t]=qi,Ky(ii,hs,_i,xi),jy(ii,ni,us),Es(ii,Wi(Di),Wi(qi),k,Pt))}}}}if(Rt){let $t=Bt.prox,tn=Or==null?Ls<=$t:Ls>$t||or!=Or;if(pt||tn){let mn=ue[0];mn!=null&&(Je[0]=Ot,Qn[0]=Ft,Ky(mn,oe,Te,Me),jy(mn,xe,Jt),Es(mn,Wi(Ot),Wi(Ft),k,Pt))}}}if(Qe.show&&sr)if(b!=null){let[ft,bt]=En.scales,[Nt,Ot]=En.match,[Ft,oe]=b.cursor.sync.scales,Te=b.cursor.drag;if(Fn=Te._x,Bn=Te._y,Fn||Bn){let{left:Me,top:xe,width:Jt,height:$t}=b.select,tn=b.scales[Ft].ori,mn=b.posToVal,zn,Ge,gn,gi,ei,Li=ft!=null&&Nt(ft,Ft),$i=bt!=null&&Ot(bt,oe);Li&&Fn?(tn==0?(zn=Me,Ge=Jt):(zn=xe,Ge=$t),gn=y[ft],gi=G(mn(zn,Ft),gn,J,0),ei=G(mn(zn+Ge,Ft),gn,J,0),Ca(ss(gi,ei),On(ei-gi))):Ca(0,J),$i&&Bn?(tn==1?(zn=Me,Ge=Jt):(zn=xe,Ge=$t),gn=y[bt],gi=N(mn(zn,oe),gn,lt,0),ei=N(mn(zn+Ge,oe),gn,lt,0),Ra(ss(gi,ei),On(ei-gi))):Ra(0,lt)}else nd()}else{let ft=On(ym-_m),bt=On(vm-xm);if(L.ori==1){let oe=ft;ft=bt,bt=oe}Fn=Hn.x&&ft>=Hn.dist,Bn=Hn.y&&bt>=Hn.dist;let Nt=Hn.uni;Nt!=null?Fn&&Bn&&(Fn=ft>=Nt,Bn=bt>=Nt,!Fn&&!Bn&&(bt>ft?Bn=!0:Fn=!0)):Hn.x&&Hn.y&&(Fn||Bn)&&(Fn=Bn=!0);let Ot,Ft;Fn&&(L.ori==0?(Ot=_o,Ft=Ke):(Ot=xo,Ft=on),Ca(ss(Ot,Ft),On(Ft-Ot)),Bn||Ra(0,lt)),Bn&&(L.ori==1?(Ot=_o,Ft=Ke):(Ot=xo,Ft=on),Ra(ss(Ot,Ft),On(Ft-Ot)),Fn||Ca(0,J)),!Fn&&!Bn&&(Ca(0,0),Ra(0,0))}if(Hn._x=Fn,Hn._y=Bn,b==null){if(D){if(Dm!=null){let[ft,bt]=En.scales;En.values[0]=ft!=null?cs(L.ori==0?Ke:on,ft):null,En.values[1]=bt!=null?cs(L.ori==1?Ke:on,bt):null}Ia(Lp,i,Ke,on,k,Pt,O)}if(te){let ft=D&&En.setSeries,bt=Bt.prox;Or==null?Ls<=bt&&ls(or,vo,!0,ft):Ls>bt?ls(null,vo,!0,ft):or!=Or&&ls(or,vo,!0,ft)}}pt&&(ht.idx=O,Qu()),E!==!1&&kn("setCursor")}let ar=null;Object.defineProperty(i,"rect",{get(){return ar==null&&Pa(!1),ar}});function Pa(b=!1){b?ar=null:(ar=p.getBoundingClientRect(),kn("syncRect",ar))}function wm(b,E,D,O,W,J,lt){ut._lock||sr&&b!=null&&b.movementX==0&&b.movementY==0||(td(b,E,D,O,W,J,lt,!1,b!=null),b!=null?Ur(null,!0,!0):Ur(E,!0,!1))}function td(b,E,D,O,W,J,lt,ft,bt){if(ar==null&&Pa(!1),Qt(b),b!=null)D=b.clientX-ar.left,O=b.clientY-ar.top;else{if(D<0||O<0){Ke=-10,on=-10;return}let[Nt,Ot]=En.scales,Ft=E.cursor.sync,[oe,Te]=Ft.values,[Me,xe]=Ft.scales,[Jt,$t]=En.match,tn=E.axes[0].side%2==1,mn=L.ori==0?k:Pt,zn=L.ori==1?k:Pt,Ge=tn?J:W,gn=tn?W:J,gi=tn?O:D,ei=tn?D:O;if(Me!=null?D=Jt(Nt,Me)?a(oe,y[Nt],mn,0):-10:D=mn*(gi/Ge),xe!=null?O=$t(Ot,xe)?a(Te,y[Ot],zn,0):-10:O=zn*(ei/gn),L.ori==1){let Li=D;D=O,O=Li}}bt&&(E==null||E.cursor.event.type==Lp)&&((D<=1||D>=k-1)&&(D=so(D,k)),(O<=1||O>=Pt-1)&&(O=so(O,Pt))),ft?(_m=D,xm=O,[_o,xo]=ut.move(i,D,O)):(Ke=D,on=O)}let ed={width:0,height:0,left:0,top:0};function nd(){Zl(ed,!1)}let Mm,Em,Am,Tm;function Cm(b,E,D,O,W,J,lt){sr=!0,Fn=Bn=Hn._x=Hn._y=!1,td(b,E,D,O,W,J,lt,!0,!1),b!=null&&(Se(Dp,Bp,Rm,!1),Ia(Hy,i,_o,xo,k,Pt,null));let{left:ft,top:bt,width:Nt,height:Ot}=Qe;Mm=ft,Em=bt,Am=Nt,Tm=Ot}function Rm(b,E,D,O,W,J,lt){sr=Hn._x=Hn._y=!1,td(b,E,D,O,W,J,lt,!1,!0);let{left:ft,top:bt,width:Nt,height:Ot}=Qe,Ft=Nt>0||Ot>0,oe=Mm!=ft||Em!=bt||Am!=Nt||Tm!=Ot;if(Ft&&oe&&Zl(Qe),Hn.setScale&&Ft&&oe){let Te=ft,Me=Nt,xe=bt,Jt=Ot;if(L.ori==1&&(Te=bt,Me=Ot,xe=ft,Jt=Nt),Fn&&rr(A,cs(Te,A),cs(Te+Me,A)),Bn)for(let $t in y){let tn=y[$t];$t!=A&&tn.from==null&&tn.min!=$e&&rr($t,cs(xe+Jt,$t),cs(xe,$t))}nd()}else ut.lock&&(ut._lock=!ut._lock,Ur(E,!0,b!=null));b!=null&&(Cn(Dp,Bp),Ia(Dp,i,Ke,on,k,Pt,null))}function cS(b,E,D,O,W,J,lt){if(ut._lock)return;Qt(b);let ft=sr;if(sr){let bt=!0,Nt=!0,Ot=10,Ft,oe;L.ori==0?(Ft=Fn,oe=Bn):(Ft=Bn,oe=Fn),Ft&&oe&&(bt=Ke<=Ot||Ke>=k-Ot,Nt=on<=Ot||on>=Pt-Ot),Ft&&bt&&(Ke=Ke<_o?0:k),oe&&Nt&&(on=on<xo?0:Pt),Ur(null,!0,!0),sr=!1}Ke=-10,on=-10,et.fill(null),Ur(null,!0,!0),ft&&(sr=ft)}function Pm(b,E,D,O,W,J,lt){ut._lock||(Qt(b),Ta(),nd(),b!=null&&Ia($y,i,Ke,on,k,Pt,null))}function Im(){S.forEach(x3),B(i.width,i.height,!0)}ao(Ou,ga,Im);let bo={};bo.mousedown=Cm,bo.mousemove=wm,bo.mouseup=Rm,bo.dblclick=Pm,bo.setSeries=(b,E,D,O)=>{let W=En.match[2];D=W(i,E,D),D!=-1&&ls(D,O,!0,!1)},gt&&(Se(Hy,p,Cm),Se(Lp,p,wm),Se(Wy,p,b=>{Qt(b),Pa(!1)}),Se(Xy,p,cS),Se($y,p,Pm),$p.add(i),i.syncRect=Pa);let jl=i.hooks=n.hooks||{};function kn(b,E,D){ti?Fe.push([b,E,D]):b in jl&&jl[b].forEach(O=>{O.call(null,i,E,D)})}(n.plugins||[]).forEach(b=>{for(let E in b.hooks)jl[E]=(jl[E]||[]).concat(b.hooks[E])});let Lm=(b,E,D)=>D,En=Tn({key:null,setSeries:!1,filters:{pub:iv,sub:iv},scales:[A,x[1]?x[1].scale:null],match:[sv,sv,Lm],values:[null,null]},ut.sync);En.match.length==2&&En.match.push(Lm),ut.sync=En;let Dm=En.key,id=tb(Dm);function Ia(b,E,D,O,W,J,lt){En.filters.pub(b,E,D,O,W,J,lt)&&id.pub(b,E,D,O,W,J,lt)}id.sub(i);function hS(b,E,D,O,W,J,lt){En.filters.sub(b,E,D,O,W,J,lt)&&bo[b](null,E,D,O,W,J,lt)}i.pub=hS;function uS(){id.unsub(i),$p.delete(i),Un.clear(),Gp(Ou,ga,Im),c.remove(),Ct?.remove(),kn("destroy")}i.destroy=uS;function sd(){kn("init",n,t),Aa(t||n.data,!1),z[A]?ju(A,z[A]):Ta(),st=Qe.show&&(Qe.width>0||Qe.height>0),nt=pt=!0,B(n.width,n.height)}return x.forEach(ho),S.forEach(Cs),e?e instanceof HTMLElement?(e.appendChild(c),sd()):e(i,sd):sd(),i}qn.assign=Tn;qn.fmtNum=Qp;qn.rangeNum=Uu;qn.rangeLog=ku;qn.rangeAsinh=Jp;qn.orient=co;qn.pxRatio=Re;qn.join=c2;qn.fmtDate=em,qn.tzDate=v2;qn.sync=tb;{qn.addGap=n3,qn.clipGaps=Vu;let n=qn.paths={points:ob};n.linear=lb,n.stepped=r3,n.bars=o3,n.spline=l3}var fb=(n,t,...e)=>X("figure",{class:n},n==="table"?db(n,t):null,...e,n==="table"?null:db(n,t)),db=(n,t)=>X("figcaption",{class:`${n}-caption`},t??"");var lm={width:26,height:4};function cm({color:n="var(--ink)",mark:t="box",dash:e}){if(t!=="line")return X("span",{class:`swatch ${t}`,style:`--swatch: ${n}`});let i=lm.height/2;return hn("svg",{class:"swatch-line",...lm,"aria-hidden":"true"},hn("line",{x1:0,x2:lm.width,y1:i,y2:i,style:`stroke: ${n}`,"stroke-width":3,"stroke-dasharray":e?.join(" ")}))}function y3({name:n,...t},e){let i=X("button",{type:"button","aria-pressed":"true",title:`Hide or show ${n}`},cm(t),n);return i.addEventListener("click",()=>{let s=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(s)),e(n,s)}),i}var pb=(n,t)=>X("div",{class:"legend",role:"group","aria-label":"Legend"},...n.map(e=>y3(e,t)));var hm=(n,t)=>oa(n)&&(!t||n>0);function v3(n,{log_x:t,log_y:e}){return n.x.map((s,r)=>({x:s,y:hm(n.y[r],e)?n.y[r]:null,low:mb(n.band_low,r,e),high:mb(n.band_high,r,e),label:n.labels?.[r],hint:n.hints?.[r]})).filter(({x:s})=>hm(s,t)).sort((s,r)=>s.x-r.x)}var mb=(n,t,e)=>n&&hm(n[t],e)?n[t]:null;function b3(n){let t=new Map;for(let e of n){let i=new Map;for(let{x:s}of e)i.set(s,(i.get(s)??0)+1);for(let[s,r]of i)t.set(s,Math.max(r,t.get(s)??0))}return[...t].sort(([e],[i])=>e-i).flatMap(([e,i])=>Array(i).fill(e))}function S3(n,t,e){let i=0;return t.map(s=>i<n.length&&n[i].x===s?n[i++][e]:void 0)}function w3(n,t,e){return(e?["y","low","high"]:["y"]).map(i=>S3(n,t,i))}function um(n){let t=n.series.map(o=>v3(o,n)),e=b3(t),i=[e],s=[],r=0;return n.series.forEach((o,a)=>{let l=!!(o.band_low&&o.band_high);i.push(...w3(t[a],e,l)),s.push({series:a,part:"y"},...l?[{series:a,part:"low"},{series:a,part:"high"}]:[]),r+=o.x.length-t[a].filter(({y:c})=>c!==null).length}),{data:i,plan:s,points:t,lost:r}}function gb(n,t,e,i){let s=null;return n.forEach((r,o)=>{if(t[o])for(let a of r){if(a.y===null)continue;let l=e(a);(!s||l<s.d)&&(s={...a,s:o,d:l})}}),s&&s.d<i?s:null}var M3=({style:n="lines"})=>n!=="points";function _b(n,t,e){let i=t.flatMap((s,r)=>e[r]&&M3(n.series[r])?s.filter(({y:o})=>o!==null).map(({x:o})=>o):[]);return[...new Set(i)].sort((s,r)=>s-r)}function xb(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return Math.abs(n[i]-t)<Math.abs(n[e]-t)?n[i]:n[e]}function dm(n,t,e){return n.flatMap((i,s)=>t[s]?i.filter(r=>r.x===e&&r.y!==null).map(r=>({...r,s})):[]).sort((i,s)=>s.y-i.y)}var fm=["blue","vermillion","green","purple","orange","sky","ink","indigo","brown","wine"];var yb=[void 0,[8,4],[2,3],[10,3,2,3]],E3=n=>`var(--${fm[n%fm.length]})`,A3=n=>yb[Math.floor(n/fm.length)%yb.length];function As(n){let t=T3(n.filter(({faint:e})=>!e).map(({name:e})=>e));return n.map(({name:e,faint:i})=>i?{color:"var(--muted)",dash:void 0}:{color:E3(t.get(e)),dash:A3(t.get(e))})}function T3(n){let t=new Map;for(let e of n)t.has(e)||t.set(e,t.size);return t}var Ts=null;function C3(n){let e=Ts.offsetWidth,i=Ts.offsetHeight,s=n.clientX+14+e>innerWidth?n.clientX-14-e:n.clientX+14,r=n.clientY+14+i>innerHeight?n.clientY-14-i:n.clientY+14;Ts.style.left=`${Math.max(0,s)}px`,Ts.style.top=`${Math.max(0,r)}px`}function vb(n,t){Ts??(Ts=document.body.appendChild(X("div",{class:"tooltip",role:"status"}))),Ts.replaceChildren(...t.map((e,i)=>X(i===0?"strong":"div",{},e))),Ts.hidden=!1,C3(n)}var bb=(n,t,e,i=!1)=>X("span",{class:i?"reading near":"reading"},cm({...n,mark:"line"}),X("span",{},t),X("span",{class:"value"},e));function Sb(){Ts&&(Ts.hidden=!0)}var R3=28,P3=14,wb=(n,t)=>{let{name:e}=n.series[t.s];return t.label??t.hint?`${e}: ${t.label??t.hint}`:e};function I3(n,t){let e=n.log_y?0:Ff(t.flat().map(({y:i})=>i));return i=>{let s=o=>he(o,void 0,e);return i.low!==null&&i.high!==null?`${s(i.y)} (${s(i.low)} to ${s(i.high)})`:s(i.y)}}var L3=(n,t,e)=>[wb(n,t),`${n.x_label??"x"}: ${he(t.x)}`,`${n.y_label??"y"}: ${e(t)}`];function D3(n,t,e,i,s){let r=t.slice(0,P3),o=r.map(l=>bb(i[l.s],wb(n,l),s(l),e?.s===l.s)),a=t.length-r.length;return[`${n.x_label??"x"}: ${he(t[0].x)}`,...o,...a?[`and ${a} more`]:[]]}function N3(n,t,e,i,s,r,o,a){let c=gb(e,i,f=>Math.hypot(n.valToPos(f.x,"x")-o,n.valToPos(f.y,"y")-a),R3),u=_b(t,e,i);if(!u.length)return c&&{words:L3(t,c,r),at:c};let d=c?c.x:xb(u,n.posToVal(o,"x")),h=dm(e,i,d);return{words:D3(t,h,c,s,r),at:c??h[0]}}function Mb(n,t,e,i,s){let r=t.over.appendChild(X("span",{class:"ring",hidden:!0})),o=As(e.series),a=I3(e,i),l=()=>{r.hidden=!0,Sb()},c=(d,h,f)=>{let p=N3(t,e,i,s,o,a,h,f);if(!p)return l();r.hidden=!1,r.style.left=`${t.valToPos(p.at.x,"x")}px`,r.style.top=`${t.valToPos(p.at.y,"y")}px`,vb(d,p.words)};t.over.addEventListener("pointerleave",l),t.over.addEventListener("pointermove",d=>{let h=t.over.getBoundingClientRect();c(d,d.clientX-h.left,d.clientY-h.top)});let u=-1;n.addEventListener("blur",l),n.addEventListener("keydown",d=>{let h={ArrowLeft:-1,ArrowRight:1}[d.key];if(d.key==="Escape"&&l(),!h)return;d.preventDefault();let f=i.flatMap((S,y)=>s[y]?S.filter(C=>C.y!==null):[]),p=[...new Set(f.map(({x:S})=>S))].sort((S,y)=>S-y);if(!p.length)return;u=Math.min(p.length-1,Math.max(0,u+h));let[g]=dm(i,s,p[u]),[m,_]=[t.valToPos(g.x,"x"),t.valToPos(g.y,"y")],x=t.over.getBoundingClientRect();c({clientX:x.left+m,clientY:x.top+_},m,_)})}var Eb=(n,t)=>n.left<t.right&&t.left<n.right&&n.top<t.bottom&&t.top<n.bottom,Ab=([n,t],{width:e,height:i})=>({left:n,top:t,right:n+e,bottom:t+i}),Tb=(n,t)=>n.left>=t.left&&n.right<=t.left+t.width&&n.top>=t.top&&n.bottom<=t.top+t.height;function Cb(n){let t=[];return n.forEach((e,i)=>{let s=n[i-1];if(!e)return;let r=s?Math.ceil(Math.hypot(e[0]-s[0],e[1]-s[1])/5):0;for(let o=1;o<r;++o)t.push(s.map((a,l)=>a+o/r*(e[l]-a)));t.push(e)}),t}function Rb([n,t],e,i,s){let r=.7*e.height;return[[n+r,t-e.height/2],[n-r-e.width,t-e.height/2],[n-e.width/2,t-r-e.height],[n-e.width/2,t+r]].map(o=>Ab(o,e)).find(o=>Tb(o,i)&&!s.some(a=>Eb(o,a)))}function O3(n,t,e,i,s){let r=n==="y"?i.width-e.width:i.height-e.height,o=n==="y"?i.left:i.top,a=[0,1,.5,.25,.75].map(c=>o+s+c*(r-2*s)),l=n==="y"?[t-s-e.height,t+s]:[t+s,t-s-e.width];return a.flatMap(c=>l.map(u=>n==="y"?[c,u]:[u,c]))}function Pb({axis:n,at:t},e,i,s,r){let o=.4*e.height,a=l=>(Tb(l,i)?0:1e6)+1e3*r.filter(c=>Eb(l,c)).length+s.filter(([c,u])=>c>l.left-o&&c<l.right+o&&u>l.top-o&&u<l.bottom+o).length;return O3(n,t,e,i,o).map(l=>Ab(l,e)).reduce((l,c)=>a(c)<a(l)?c:l)}var U3=12,Ib=n=>`${U3*n}px system-ui, sans-serif`,F3=(n,t)=>t.label??(n.x.length===1&&n.style==="points"?n.name:null),Lb=(n,t)=>t.map(({x:e,y:i})=>i===null?null:[n.valToPos(e,"x",!0),n.valToPos(i,"y",!0)]);function B3(n,t,e,i,s){let{left:r,top:o,width:a,height:l}=n.bbox,c={lines:[],texts:[]};for(let{axis:u="y",value:d,label:h}of t){let f=Math.round(n.valToPos(d,u,!0));if(c.lines.push(u==="y"?[r,f,r+a,f]:[f,o,f,o+l]),!h)continue;let p=Pb({axis:u,at:f},i(h),n.bbox,e,s);s.push(p),c.texts.push({text:h,place:p,color:"--muted"})}return c}function k3(n,t,e,i,s,r){let o=As(t.series),a=[];return e.forEach((l,c)=>{if(!i[c])return;let u=Lb(n,l);l.forEach((d,h)=>{let f=F3(t.series[c],d);f&&u[h]&&a.push({text:f,at:u[h],color:o[c].color})})}),a.flatMap(({text:l,at:c,color:u})=>{let d=Rb(c,s(l),n.bbox,r);return d?(r.push(d),[{text:l,place:d,color:u}]):[]})}function $u(n,t,e,i){let s=devicePixelRatio;n.ctx.save(),n.ctx.font=Ib(s);let r=h=>({width:n.ctx.measureText(h).width,height:13*s}),o=e.map((h,f)=>i[f]?Lb(n,h):[]),a=4*s,l=o.flat().filter(Boolean).map(([h,f])=>({left:h-a,right:h+a,top:f-a,bottom:f+a})),c=o.flatMap((h,f)=>t.series[f].style==="points"?h.filter(Boolean):Cb(h)),u=[],d=B3(n,t.reference_lines??[],c,r,u);return l.push(...u),d.texts.push(...k3(n,t,e,i,r,l)),n.ctx.restore(),d}function z3(n,{text:t,place:e,color:i},s){let r=(e.top+e.bottom)/2;n.lineWidth=4*s,n.strokeStyle=en("--page"),n.strokeText(t,e.left,r),n.fillStyle=en(i),n.fillText(t,e.left,r)}function Db(n,{lines:t,texts:e}){let{ctx:i}=n,s=devicePixelRatio;i.save(),i.setLineDash([5*s,4*s]),i.lineWidth=s,i.strokeStyle=en("--muted");for(let[r,o,a,l]of t)i.beginPath(),i.moveTo(r,o),i.lineTo(a,l),i.stroke();i.setLineDash([]),i.font=Ib(s),i.textAlign="left",i.textBaseline="middle";for(let r of e)z3(i,r,s);i.restore()}var G3=320,Nb="12px system-ui, sans-serif",V3=1e-4;function H3(n,{series:t,part:e},i,s){let r=n.series[t].style??"lines";return e!=="y"?{stroke:"transparent",width:0,points:{show:!1}}:{label:n.series[t].name,stroke:()=>i(t)+(n.series[t].faint?"a0":""),width:r==="points"?0:n.series[t].faint?1:2,dash:s,paths:r==="points"?()=>null:void 0,points:{show:r==="points"||r==="both",size:8,fill:()=>i(t),stroke:()=>i(t)}}}var W3=(n,t)=>n.flatMap(({series:e,part:i},s)=>i==="high"?[{series:[s+1,s],fill:()=>`${t(e)}33`}]:[]),Ob=(n,t)=>({label:n,labelSize:26,labelFont:Nb,font:Nb,stroke:()=>en("--ink"),grid:{stroke:()=>en("--faint"),width:1},ticks:{stroke:()=>en("--faint")},...t?{splits:X3,filter:(e,i)=>i}:{},values:(e,i)=>t?i.map(s=>he(s)):Bf(i)});function X3(n,t,e,i){let s=Math.floor(Math.log10(e)),r=Math.ceil(Math.log10(i)),o=Math.ceil((r-s)/9),a=r-s<=2?[1,2,5]:[1],l=[];for(let c=Math.ceil(s/o)*o;c<=r;c+=o)l.push(...a.map(u=>+`${u}e${c}`));return l.filter(c=>c>=e&&c<=i)}function Ub(n,t){return(e,i,s)=>{let r=[i,s,...t].filter(a=>oa(a)&&(!n||a>0)),o=X_(n?r.map(Math.log10):r,.06,V3);return n?o.map(a=>10**a):o}}function Fb(n,t,e,i){let s=As(n.series),r=a=>en(s[a].color),o=a=>(n.reference_lines??[]).filter(l=>(l.axis??"y")===a).map(l=>l.value);return{width:i,height:n.height??G3,legend:{show:!1},padding:[12,16,0,0],cursor:{drag:{x:!0,y:!0,uni:20},points:{show:!1}},scales:{x:{time:!1,distr:n.log_x?3:1,range:Ub(n.log_x,o("x"))},y:{distr:n.log_y?3:1,range:Ub(n.log_y,o("y"))}},axes:[{...Ob(n.x_label,n.log_x),size:34},{...Ob(n.y_label,n.log_y),size:64}],series:[{},...t.plan.map(a=>H3(n,a,r,s[a.series].dash))],bands:W3(t.plan,r),hooks:{draw:[a=>Db(a,$u(a,n,t.points,e))]}}}function Bb(n){let t="M";return n.map(([e,i])=>{if(!Number.isFinite(e)||!Number.isFinite(i))return t="M","";let s=`${t}${e.toFixed(1)} ${i.toFixed(1)}`;return t="L",s}).join("")}var $3=0,pm=(n,t,e,i,s,r={})=>hn("line",{x1:n,y1:t,x2:e,y2:i,stroke:s,...r});function q3(n,t,{x_label:e,y_label:i}){let s=en("--ink"),r=en("--faint"),[o,a]=n.axes.map(({_splits:c,_values:u})=>(c??[]).map((d,h)=>({value:d,text:u[h]}))),l=(c,u)=>hn("text",{style:`fill: ${s}`,...c},u??"");return[...o.flatMap(({value:c,text:u})=>[pm(t.x(c),t.top,t.x(c),t.bottom,r),l({x:t.x(c),y:t.bottom+18,"text-anchor":"middle"},u)]),...a.flatMap(({value:c,text:u})=>[pm(t.left,t.y(c),t.right,t.y(c),r),l({x:t.left-8,y:t.y(c)+4,"text-anchor":"end"},u)]),l({x:(t.left+t.right)/2,y:t.bottom+46,"text-anchor":"middle"},e),l({"text-anchor":"middle",transform:`translate(14 ${(t.top+t.bottom)/2}) rotate(-90)`},i)]}function Y3({style:n="lines",faint:t},e,{color:i,dash:s},r){let o=en(i),a=u=>Bb(e.map(d=>[r.x(d.x),d[u]===null?NaN:r.y(d[u])])),l=e.filter(({low:u,high:d})=>u!==null&&d!==null),c=u=>l.map(d=>`${r.x(d.x).toFixed(1)} ${r.y(d[u]).toFixed(1)}`);return[l.length>1?hn("path",{fill:o,"fill-opacity":.2,d:`M${[...c("low"),...c("high").reverse()].join("L")}Z`}):null,n==="points"?null:hn("path",{fill:"none",stroke:o,"stroke-width":t?1:2,"stroke-opacity":t?.63:1,"stroke-dasharray":s?.join(" "),d:a("y")}),...n==="lines"?[]:e.filter(({y:u})=>u!==null).map(u=>hn("circle",{fill:o,cx:r.x(u.x),cy:r.y(u.y),r:4}))]}function kb(n,t,e,i){let s=devicePixelRatio,{left:r,top:o,width:a,height:l}=n.bbox,c={left:r/s,top:o/s,right:(r+a)/s,bottom:(o+l)/s,x:p=>n.valToPos(p,"x",!0)/s,y:p=>n.valToPos(p,"y",!0)/s},u=As(t.series),d=$u(n,t,e,i),h=en("--muted"),f=`chart-clip-${++$3}`;return hn("svg",{class:"plot",width:n.width,height:n.height,viewBox:`0 0 ${n.width} ${n.height}`},hn("clipPath",{id:f},hn("rect",{x:c.left,y:c.top,width:a/s,height:l/s})),...q3(n,c,t),hn("g",{"clip-path":`url(#${f})`},...t.series.flatMap((p,g)=>i[g]?Y3(p,e[g],u[g],c):[])),...d.lines.map(p=>pm(...p.map(g=>g/s),h,{"stroke-dasharray":"5 4"})),...d.texts.map(({text:p,place:g,color:m})=>hn("text",{style:`fill: ${en(m)}`,x:g.left/s,y:(g.top+g.bottom)/2/s+4},p)))}function Z3(n,t){let e=()=>{removeEventListener("beforeprint",e),i.disconnect(),n()},i=t(e);addEventListener("beforeprint",e)}var zb=(n,t)=>Z3(t,e=>{let i=new ResizeObserver(()=>n.clientWidth&&e());return i.observe(n),i});var j3=1/60;function J3(n,t){let e=n.map((r,o)=>o).filter(r=>Number.isFinite(t[r])),i=j3*(n.at(-1)-n[0]),s=(r,o)=>r===void 0||o===void 0||n[o]-n[r]>i;return e.filter((r,o)=>s(e[o-1],r)||s(r,e[o+1]))}function K3(n,t,e,i){let s=Fb(n,t,e,i);for(let{points:r}of s.series.slice(1))r.size=5,r.filter=(o,a)=>J3(o.data[0],o.data[a]);return s}function qu(n){let t={...n,type:"lines"},e=um(t),i=t.series.map(()=>!0),s=X("div",{class:"chart",role:"img",tabindex:0,"aria-label":`${t.caption}: ${t.y_label} over ${t.x_label}; arrow keys tell values`}),r=null,o=(d,h)=>t.series.forEach((f,p)=>{f.name===d&&(i[p]=h,r?.setSeries(1+e.plan.findIndex(g=>g.series===p),{show:h}))});zb(s,()=>{r=new qn(K3(t,e,i,s.clientWidth),e.data,s),Mb(s,r,t,e.points,i),new ResizeObserver(()=>{let d=s.clientWidth;d&&d!==r.width&&r.setSize({width:d,height:r.height})}).observe(s),s.toSvg=()=>kb(r,t,e.points,i),s.redraw=()=>r.redraw(!1,!0)});let a=As(t.series),l=t.series.map(({name:d},h)=>({name:d,...a[h],mark:"line"})),c=fb("figure",t.caption,pb(l,o),s),u=d=>{Object.assign(t,d);let h=um(t);e.points.splice(0,e.points.length,...h.points),e.data=h.data,r&&r.setData(h.data)};return{figure:Z0(t,c),update:u}}var Q3=Math.PI/900;function tL(n,t){let{scale:e,unit:i}=Zs(t),s=n.x.map(c=>c/e),r=c=>Object.entries(c??{}).map(([u,d])=>({name:u,x:s,y:d.map(h=>h===null?null:h*1e3)})),o=c=>[{axis:"x",value:c/e}],l={x_label:`${t.name} [${i}]`,height:210};return{cursor:o,arms:{...l,caption:`Moment arms over ${t.name}`,y_label:"moment arm [mm]",series:r(n.arms)},lengths:{...l,caption:`Lengths over ${t.name}`,y_label:"longer than at 0\xB0 [mm]",series:r(n.lengths)}}}function eL(n,t){let e=tL(n,t),i=["arms","lengths"].filter(s=>e[s].series.length).map(s=>{let r={...e[s],reference_lines:e.cursor(n.x[0])};return{block:r,chart:qu(r)}});return{joint:t,element:X("div",{class:"charts"},...i.map(({chart:s})=>s.figure)),cursor:s=>i.forEach(({block:r,chart:o})=>o.update({...r,reference_lines:e.cursor(s)}))}}function Gb(n){let t=X("div",{}),e=Ln("Over",()=>{}),i=[],s=null,r=null;async function o(){let l=i.find(({name:u})=>u===e.value());if(!l)return;let c=await n.ask("tendons.sweep",{joint:l.name,what:["arms","lengths"]});if(c){s=eL(c,l),t.replaceChildren(s.element);for(let u of c.warnings??[])t.prepend(X("p",{class:"warning"},u));a.follow(r)}}let a={element:We("Over a joint",e,X("div",{class:"buttons"},ke("Plot",o,{id:"plot-sweep"})),t),offer:l=>{i=l,e.set(i.map(({name:c})=>c))},clear:()=>{s=null,t.replaceChildren()},follow:l=>{if(r=l,!s||!l)return;let c=l(s.joint.name);!Number.isFinite(c)||Math.abs(c-(s.drawn??1/0))<Q3||(s.drawn=c,s.cursor(c))}};return a}var nL=100,iL=.01,sL=200,rL=n=>n.max_force??n.strength??n.upper??nL;function oL({tip_force:n,rotation:t,torques:e,status:i,muscles:s=[]}){let r=[],o=Math.max(1,...s.map(({tension:a})=>a??0));if(n){let a=n.map(c=>Tu(c,o)),l=no(a,t).map(c=>Tu(c,o));r.push(["Tip force",`${he(Math.hypot(...a),2)}\u202FN`]),r.push(["along x, y, z",`${l.map(c=>he(c,2)).join(", ")} N`])}for(let[a,l]of Object.entries(e??{}))r.push([`Torque ${a}`,`${he(Tu(l,o*iL)*1e3)} N mm`]);return i&&r.push(["Status",String(i)]),r}function aL(n,t,e){let i=(s,r,o,a,l)=>({name:r,row:xs({name:r,lower:o,upper:a,quantity:l},c=>e(s,r,c))});return{posture:n.map(s=>i("posture",s.name,s.lower,s.upper,Zs(s))),tensions:t.map(s=>i("tensions",s.name,0,rL(s),Vi.force)),excitations:t.map(s=>i("excitations",s.name,0,1,Vi.share))}}function lL(n){let t={posture:X("div",{}),tensions:X("div",{}),excitations:X("div",{})},e={posture:[],tensions:[],excitations:[]},i=(a,l)=>{e=aL(a,l,n);for(let[c,u]of Object.entries(t))u.replaceChildren(...e[c].map(({row:d})=>d))},s=a=>{e.tensions.forEach(({row:l},c)=>l.set(a[c]?.tension)),e.excitations.forEach(({row:l},c)=>l.set(a[c]?.excitation??l.value()))},r=a=>e.posture.forEach(({name:l,row:c})=>c.set(a(l)));return{elements:[We("Posture",t.posture),We("Tensions",t.tensions),We("Excitations",t.excitations)],build:i,show:s,follow:r}}function cL(){let t=Js(["muscle","tension [N]","longer than at 0\xB0 [mm]"],[],"Tensions"),e=Js(["band","tension [N]",""],[],"Bands"),i=X("div",{}),s=r=>{Ks(t.querySelector("tbody"),(r.muscles??[]).map(a=>[a.name,he(a.tension,2),he(a.length*1e3,2)]));let o=r.bands??[];e.hidden=o.length===0,Ks(e.querySelector("tbody"),o.map(a=>[a.name,he(a.tension,2),a.slack?"slack":""])),i.replaceChildren(ys(oL(r)),...tu(r.warnings))};return{element:We("At rest",i,t,e),show:s}}function Vb(n){let{store:t}=n,e=Qs(async({method:p,params:g})=>{let m=await n.ask(p,g);m&&d(m)},nu),i=lL((p,g,m)=>e({method:"tendons.set",params:{[p]:{[g]:m}}})),s=cL(),r=Gb(n),o=X("div",{class:"hint"},"No digit with tendons is shown."),a=X("div",{class:"buttons"},ke("Open a digit\u2026",()=>n.openDialog("subjects")),la(n)),l=X("div",{class:"parts"},...i.elements,s.element,r.element),c=X("div",{class:"page tendons"},o,a,l),u=()=>t.scene?.mode==="tendons";function d(p){let g=p.muscles??[],{joints:m}=t.scene,_=JSON.stringify([p.subject,p.digit,g.map(x=>x.name),m]);if(c.dataset.key!==_){let x=m.filter(S=>!S.led_by);i.build(x,g),r.offer(x),r.clear()}c.dataset.key=_,i.show(g),s.show(p)}let h=eu(async()=>{if(c.hidden||!u()||!n.link.connected())return;let p=await n.ask("tendons.state");p&&d(p)},sL),f=()=>{l.hidden=!u(),o.hidden=u(),u()&&h()};return t.on(["scene","tab"],f),t.on(["frame"],()=>{if(u()&&t.frame){let p=g=>t.frame.joints[t.scene.joints.findIndex(m=>m.name===g)];i.follow(p),r.follow(p)}c.hidden||h()}),f(),c}var hL=200,Hb=1500,uL=n=>Object.fromEntries(Object.entries(n??{}).filter(([,t])=>Number.isFinite(t)));function dL(){let n={t:[],values:new Map};return n.add=(t,e)=>{for(;n.t.length&&n.t.at(-1)>=t;){n.t.pop();for(let i of n.values.values())i.pop()}for(let i of Object.keys(e))n.values.has(i)||n.values.set(i,n.t.map(()=>null));n.t.push(t);for(let[i,s]of n.values)s.push(e[i]??null);if(n.t.length>Hb){let i=(s,r)=>r%2===0||r>Hb/2;n.t=n.t.filter(i);for(let[s,r]of n.values)n.values.set(s,r.filter(i))}},n.clear=()=>{n.t=[],n.values=new Map},n.series=()=>[...n.values].map(([t,e])=>({name:t,x:n.t,y:e})),n}function fL(n){return{caption:"Energies",x_label:"time [s]",y_label:"energy [J]",height:200,series:n.series()}}var pL=({beyond_rad:n,beyond_m:t})=>t===void 0?`${he(n*180/Math.PI)}\u202F\xB0`:`${he(t*1e3)}\u202Fmm`;function mL(n){let t=[];if(Number.isFinite(n.energy_error)){let[e,i]=[n.energy_error,n.energy_turned_over].map(r=>he(Math.abs(r)*1e3)),s=n.energy_error<0?"created":"unaccounted for";t.push(["Energy error",`${e} mJ ${s}, of ${i} mJ turned over`])}return Number.isFinite(n.deepest)&&t.push(["Deepest overlap",`${he(n.deepest*1e3)}\u202Fmm`]),n.limits_passed?.length&&t.push(["Limits passed",n.limits_passed.map(e=>`${e.joint} by ${pL(e)}`).join(", ")]),n.restitution_ignored>0&&t.push(["Restitution ignored",`up to ${he(n.restitution_ignored)}`]),t}function gL(n){let t=[];return n.energy_balances===!1&&t.push("Energy does not balance: do not use this motion. Shorter steps may help."),n.unsolved&&t.push(`${n.unsolved} of ${n.steps} steps missed the tolerance of their contacts; the largest residual is ${he(n.worst_residual??NaN)}.`),t.join(" ")}function Wb(n){let t=dL(),e=X("div",{class:"charts"}),i=X("div",{class:"account"}),s=X("p",{class:"warning",role:"alert",hidden:!0}),r=null,o=!1,a=null;function l(f){let p=gL(f);s.hidden=!p,s.textContent=p,i.replaceChildren(ys(mL(f)))}function c(){if(a=null,!t.t.length)return;let f=[...t.values.keys()].join(),p=fL(t);r?.names===f?r.update(p):(r={...qu(p),names:f},e.replaceChildren(r.figure))}async function u(){let f=await n.call("motion.state",{want:["energy"]}).catch(()=>null);return f&&l(f),f}async function d(){if(o)return;o=!0;let f=await u();o=!1;let p=uL(f?.energy);Object.keys(p).length&&(t.add(f.t,p),a??(a=setTimeout(c,hL)))}return{element:e,account:i,warning:s,follow:d,tell:u,clear:()=>{t.clear(),s.hidden=!0,i.replaceChildren()}}}var Xb={effort:{param:"efforts",reach:10},target:{param:"targets",reach:Math.PI},tension:{param:"tensions",reach:100},excitation:{param:"excitations",reach:1}};function _L({unit:n}){return n==="rad"?Vi.angle:n==="m"?Vi.length:{unit:n==="1"?"":n,scale:1,digits:3,step:.01,big:.1}}function $b(n){let t=n.split("/");return{group:t.slice(0,-1).join(" "),short:t.at(-1)}}var qb=({kind:n,name:t})=>`${n} ${t}`;function Yb(n){let t=X("div",{}),e=Ln("Input",()=>o()),i=We("Inputs",e,t),s=[],r=Qs(l=>n.ask("motion.set",l));function o(){let l=s.find(_=>qb(_)===e.value());if(!l)return t.replaceChildren();let{param:c,reach:u}=Xb[l.kind],d=_L(l),h=l.lower??(c==="efforts"||c==="targets"?-u:0),f=l.upper??u,{short:p}=$b(l.name),g={name:p,title:l.name,lower:h,upper:f,quantity:d},m=xs(g,_=>{l.set=_,r({[c]:{[l.name]:_}})});m.set(l.set??0),t.replaceChildren(m)}async function a(){s=((await n.ask("motion.inputs"))?.inputs??[]).filter(({kind:u})=>u in Xb),i.hidden=s.length===0;let c=u=>{let{group:d,short:h}=$b(u.name);return{value:qb(u),text:`${h} (${u.kind})`,group:d}};e.set(s.map(c)),o()}return{element:i,refill:a}}var xL=["0.05","0.1","0.25","0.5","1","2"],yL=12,jb=1e-9,Zb=xL.map(n=>({value:n,text:`${n} \xD7`}));function vL(n,{contacts:t}){let e=i=>n.bodies[i]?.name??"world";return t.map(i=>({...i,size:Math.hypot(...i.force)})).sort((i,s)=>s.size-i.size).slice(0,yL).map(i=>[`${e(i.a)} on ${e(i.b)}`,he(i.size,2),he(i.friction,2)])}function Jb(n){let t=n.store.state?.motion;return t?.shown?t:null}function bL(n,t){return!n||n.playing||n.recorded||n.duration==null?!1:Math.abs(t-n.duration)<=jb}function SL(n,t){let e=()=>Jb(n),i=X("output",{class:"clock"}),s=De("Play",()=>h(),{id:"play",class:"main"}),r=X("input",{type:"range",min:0,max:1,value:0,step:"any","aria-label":"Time [s]",class:"scrub"}),o=()=>({speed:Number(a.value())}),a=Ln("Speed",()=>e()?.playing&&n.ask("motion.play",o()));a.set(Zb,"1");let l=Qs(y=>n.ask("motion.seek",{t:y}));r.addEventListener("input",()=>l(Number(r.value)));let c=0,u=X("p",{class:"hint",id:"scene-end",role:"status",hidden:!0},"The time of the scene ends here. Play goes on."),d=y=>u.hidden=!bL(e(),y);async function h(){e()&&(e().playing?await n.ask("motion.pause"):await n.ask("motion.play",o()))}let f=y=>n.ask("motion.step",{steps:y}),p=()=>c=0;async function g(){t.clear(),p(),await n.ask("motion.reset")}let m=[ke("Step",()=>f(1),{id:"step",title:"One step of time"}),ke("10 steps",()=>f(10)),ke("Reset",g,{title:"Back to the beginning"})],_=({time:y})=>{let{duration:C,recorded:A}=e()??{};c=Math.max(c,y,A&&C||0),r.max=c||1,r.value=y,r.setAttribute("aria-valuetext",`${y.toFixed(3)} s`);let v=C&&y<=C+jb?` of ${C.toFixed(3)}`:"";i.textContent=`${y.toFixed(3)}${v}\u202Fs`,d(y)},x=y=>{s.textContent=y?.playing?"Pause":"Play",s.setAttribute("aria-pressed",String(!!y?.playing)),y?.speed&&a.set(Zb,String(y.speed));for(let C of m)C.hidden=!!y?.recorded;d(n.store.frame?.time??NaN)};return{element:[X("div",{class:"buttons"},s,...m),X("div",{class:"scrubber"},r,i),u,a],follow:_,show:x,forget:p,toggle:h,step:f}}function wL(n,t){let e=()=>(t.clear(),n.ask("motion.open")),i=X("p",{class:"hint"}),s=ke("Show the motion",()=>n.ask("session.mode",{mode:"motion"})),r=ke("Begin from this world",e,{id:"begin-motion"}),o=ke("Open a scene\u2026",()=>n.openDialog("scenes")),a=(c,u)=>{i.textContent=c?"":u?"A motion is open, but not shown.":"No motion is open: begin with the world as it stands, or open a scene.",i.hidden=c,s.hidden=c||!u,r.textContent=c?"Begin anew from the world":"Begin from this world"},l=X("div",{class:"buttons"},s,r,o,la(n));return{hint:i,buttons:l,show:a}}function Kb(n){let{store:t}=n,e=Wb(n),i=Yb(n),s=SL(n,e),r=wL(n,e),o=Js(["contact","force [N]","friction"],[],"Contacts"),a=We("Energy",e.element),l=X("div",{class:"parts"},...s.element,e.warning,i.element,We("Contacts",o),We("Reliability",e.account),a),c=Qh("Run",m=>n.ask("motion.record",{file:m})),u=X("div",{class:"page time"},r.hint,r.buttons,c,l),d=()=>t.scene?.mode==="motion",h=()=>Jb(n),f=()=>{u.hidden||!t.frame||!d()||(s.follow(t.frame),Ks(o.querySelector("tbody"),vL(t.scene,t.frame)),h()?.recorded||e.follow())},p=()=>{l.hidden=!d(),a.hidden=!!h()?.recorded,r.show(d(),t.state?.motion??null),s.show(h())};t.on(["scene","state","tab"],p),t.on(["frame","tab"],f);let g=null;return t.on(["link"],({link:m})=>g=m?g:null),t.on(["scene"],({scene:m})=>{m.revision!==g&&(g=m.revision,e.clear(),s.forget(),d()&&(i.element.hidden=!!h()?.recorded,h()?.recorded?e.tell():i.refill()))}),n.togglePlay=s.toggle,n.stepTime=s.step,p(),u}var ML=[["hand","Hands"],["object","Objects"],["obstacle","Obstacles"]];function EL(n,{name:t,movable:e}){let{store:i,picture:s}=n,r=s.bodies.hidden.has(t),o=De(t,()=>n.select({owner:t}),{class:"pick","aria-pressed":String(i.selected?.owner===t),title:e?`Select ${t}`:`Select ${t}, which stands fast`}),a=De(r?"\u25CB":"\u25CF",()=>n.hide(t,!r),{class:"eye","aria-pressed":String(!r),"aria-label":`Show ${t}`,title:r?"Show":"Hide"}),l=De("\xD7",()=>n.ask("world.remove",{name:t}),{class:"away","aria-label":`Remove ${t}`,title:"Remove from the world"});return X("li",{},a,o,i.scene.mode==="world"?l:null)}function Qb(n){let{store:t}=n,e=X("div",{class:"tree-body"}),i=X("nav",{class:"tree","aria-label":"World"},X("h2",{},"World"),e),s=()=>{let r=t.scene?Er(t.scene):[],o=document.activeElement?.closest(".tree")?document.activeElement:null,a=o&&[o.className,o.closest("li")?.textContent],l=ML.flatMap(([u,d])=>{let h=r.filter(f=>f.kind===u);return h.length?[X("h3",{},d),X("ul",{},...h.map(f=>EL(n,f)))]:[]}),c=X("p",{class:"hint"},"Nothing is here yet. Open a world, add a hand or an object, or drop files onto the picture.");e.replaceChildren(...l.length?l:[c]),a&&[...e.querySelectorAll("button")].find(u=>u.className===a[0]&&u.closest("li").textContent===a[1])?.focus()};return t.on(["scene","selected","hidden"],s),s(),i}var AL={world:"pose",motion:"time",tendons:"tendons",fit:"fit"},Yu=matchMedia("(max-width: 700px)");function TL(n,t){let e=[{id:"pose",title:"Pose",element:P_(n)},{id:"grasp",title:"Grasp",element:Fy(n)},{id:"tendons",title:"Tendons",element:Vb(n)},{id:"fit",title:"Fit",element:Qx(n)},{id:"time",title:"Time",element:Kb(n)},{id:"world",title:"World",element:X("div",{class:"page world"})}];n.tabs=r_(e,"Panels",l=>n.store.set({tab:l}));let i=De("\u25BE",()=>{let l=s.classList.toggle("folded");i.setAttribute("aria-expanded",String(!l)),i.textContent=l?"\u25B4":"\u25BE",mm(n)},{class:"fold-panel","aria-expanded":"true","aria-label":"Fold the panel"}),s=X("aside",{class:"side","aria-label":"Controls"},X("div",{class:"side-head"},n.tabs.list,i),X("div",{class:"pages"},...e.map(({element:l})=>l))),r=X("div",{class:"tree-home"}),o=()=>{(Yu.matches?e.at(-1).element:r).append(t),!Yu.matches&&n.tabs.chosen()==="world"&&n.tabs.choose("pose")};Yu.addEventListener("change",o),o(),n.tabs.choose("pose");let a="world";return n.store.on(["scene"],({scene:l})=>{l.mode!==a&&n.tabs.choose(AL[l.mode]??"pose"),a=l.mode}),{side:s,home:r}}function mm(n){let t=a=>document.querySelector(a)?.getBoundingClientRect(),[e,i,s]=[t(".bar"),t(".side"),t(".tree-home")],r=Yu.matches,o={top:e?.bottom??0,left:r||!s?.width?0:s.right,right:r?0:innerWidth-(i?.left??innerWidth),bottom:r?innerHeight-(i?.top??innerHeight):0};for(let[a,l]of Object.entries(o))document.documentElement.style.setProperty(`--inset-${a}`,`${l}px`);n.legend.measure(),n.picture.stage.setInsets(o)}function CL(){let n=X("main",{class:"view","aria-label":"Picture"});document.body.append(n);let t=zx(document.body,n);t.help=o_(),t.openDialog=ky(t);let{side:e,home:i}=TL(t,Qb(t));document.body.prepend(qx(t),i),n.after(e),t.picture.stage.canvas.setAttribute("role","application"),t.picture.stage.canvas.setAttribute("aria-label","3D picture; press ? for its keys"),t.picture.stage.canvas.addEventListener("dblclick",()=>t.view.fit()),Xx(t),$x(t),zm(),addEventListener("resize",()=>mm(t)),mm(t),globalThis.thenarLive=t}try{CL()}catch(n){throw document.body.append(X("p",{class:"broken",role:"alert"},`The page cannot be shown: ${n.message}`)),n}})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)

lil-gui/dist/lil-gui.esm.js:
  (**
   * lil-gui
   * https://lil-gui.georgealways.com
   * @version 0.21.0
   * @author George Michael Brower
   * @license MIT
   *)
*/
