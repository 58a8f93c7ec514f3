/*! Contains three.js (MIT, three.js authors), uPlot (MIT, Leon Sorokin), lil-gui (MIT, George Michael Brower). */
(()=>{var TS="http://www.w3.org/2000/svg";function wm(n,t,e){for(let[i,s]of Object.entries(t))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):i==="style"?n.style.cssText=s:n.setAttribute(i,s===!0?"":s));return n.append(...e.filter(i=>i!=null)),n}var X=(n,t={},...e)=>wm(document.createElement(n),t,e),cn=(n,t={},...e)=>wm(document.createElementNS(TS,n),t,e);var Em=new Set,Am=()=>Em.forEach(n=>n()),rn=n=>getComputedStyle(document.documentElement).getPropertyValue(n.replace(/^var\(|\)$/g,"")).trim(),Tm=n=>Em.add(n);function Mm(n){document.documentElement.classList.toggle("printing",n),document.querySelectorAll("details").forEach(t=>{n&&(t.open=!0)}),Am()}function Cm(){matchMedia("(prefers-color-scheme: dark)").addEventListener("change",Am),addEventListener("beforeprint",()=>Mm(!0)),addEventListener("afterprint",()=>Mm(!1))}var xr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},yr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},hg=0,Ld=1,ug=2;var Hs=1,dg=2,jo=3,vr=0,ai=1,on=2,qr=0,Jo=1,Dd=2,Nd=3,Od=4,fg=5;var Zr=100,pg=101,mg=102,gg=103,_g=104,xg=200,yg=201,vg=202,Sg=203,Ud=204,Fd=205,bg=206,wg=207,Mg=208,Eg=209,Ag=210,Tg=211,Cg=212,Rg=213,Pg=214,bc=0,wc=1,Mc=2,ko=3,Ec=4,Ac=5,Tc=6,Cc=7,eh=0,Ig=1,Lg=2,ms=0,Bd=1,kd=2,zd=3,Gd=4,Vd=5,Hd=6,Wd=7;var Xd=300,jr=301,Ko=302,nh=303,ih=304,Rc=1e3,fs=1001,Pc=1002,Gn=1003,Dg=1004;var cl=1005;var ri=1006,sh=1007;var Ws=1008;var di=1009,$d=1010,Yd=1011,Qo=1012,rh=1013,Ji=1014,zi=1015,Ki=1016,oh=1017,ah=1018,Jr=1020,qd=35902,Zd=35899,jd=1021,Jd=1022,Qi=1023,ks=1026,Xs=1027,lh=1028,ch=1029,Sr=1030,hh=1031;var uh=1033,hl=33776,ul=33777,dl=33778,fl=33779,dh=35840,fh=35841,ph=35842,mh=35843,gh=36196,_h=37492,xh=37496,yh=37488,vh=37489,pl=37490,Sh=37491,bh=37808,wh=37809,Mh=37810,Eh=37811,Ah=37812,Th=37813,Ch=37814,Rh=37815,Ph=37816,Ih=37817,Lh=37818,Dh=37819,Nh=37820,Oh=37821,Uh=36492,Fh=36494,Bh=36495,kh=36283,zh=36284,ml=36285,Gh=36286;var za=2300,Ic=2301,vc=2302,Md=2303,Ed=2400,Ad=2401,Td=2402;var Ng=3200;var gl=0,Og=1,$s="",vi="srgb",Ga="srgb-linear",Va="linear",Pe="srgb";var Sc=7680;var Ug=519,Fg=512,Bg=513,kg=514,Kd=515,zg=516,Gg=517,Qd=518,tf=519,ef=35044,nf=35048;var sf="300 es",Ni=2e3,zo=2001;function CS(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function RS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ha(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Vg(){let n=Ha("canvas");return n.style.display="block",n}var Rm={},Go=null;function Wa(...n){let t="THREE."+n.shift();Go?Go("log",t,...n):console.log(t,...n)}function Hg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=Hg(n);let t="THREE."+n.shift();if(Go)Go("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ee(...n){n=Hg(n);let t="THREE."+n.shift();if(Go)Go("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Ba(...n){let t=n.join(" ");t in Rm||(Rm[t]=!0,qt(...n))}function Wg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Xg={[bc]:bc,[Mc]:Tc,[Ec]:Ec,[ko]:Ac,[wc]:wc,[Tc]:Mc,[Cc]:Cc,[Ac]:ko},ji=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Pm=1234567,Fo=Math.PI/180,Vo=180/Math.PI;function br(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Zn[n&255]+Zn[n>>8&255]+Zn[n>>16&255]+Zn[n>>24&255]+"-"+Zn[t&255]+Zn[t>>8&255]+"-"+Zn[t>>16&15|64]+Zn[t>>24&255]+"-"+Zn[e&63|128]+Zn[e>>8&255]+"-"+Zn[e>>16&255]+Zn[e>>24&255]+Zn[i&255]+Zn[i>>8&255]+Zn[i>>16&255]+Zn[i>>24&255]).toLowerCase()}function ce(n,t,e){return Math.max(t,Math.min(e,n))}function rf(n,t){return(n%t+t)%t}function PS(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function IS(n,t,e){return n!==t?(e-n)/(t-n):0}function ka(n,t,e){return(1-e)*n+e*t}function LS(n,t,e,i){return ka(n,t,1-Math.exp(-e*i))}function DS(n,t=1){return t-Math.abs(rf(n,t*2)-t)}function NS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function OS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function US(n,t){return n+Math.floor(Math.random()*(t-n+1))}function FS(n,t){return n+Math.random()*(t-n)}function BS(n){return n*(.5-Math.random())}function kS(n){n!==void 0&&(Pm=n);let t=Pm+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function zS(n){return n*Fo}function GS(n){return n*Vo}function VS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function HS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function of(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function WS(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),d=r((t-i)/2),u=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*d,l*u,a*c);break;case"YZY":n.set(l*u,a*h,l*d,a*c);break;case"ZXZ":n.set(l*d,l*u,a*h,a*c);break;case"XZX":n.set(a*h,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*h,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*h,a*c);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Vh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function af(n,t){if(t.constructor===Float32Array)return n;let e=Vh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function lf(n,t){if(t.constructor===Float32Array)return n;let e=Vh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var ta={DEG2RAD:Fo,RAD2DEG:Vo,generateUUID:br,clamp:ce,euclideanModulo:rf,mapLinear:PS,inverseLerp:IS,lerp:ka,damp:LS,pingpong:DS,smoothstep:NS,smootherstep:OS,randInt:US,randFloat:FS,randFloatSpread:BS,seededRandom:kS,degToRad:zS,radToDeg:GS,isPowerOfTwo:VS,ceilPowerOfTwo:HS,floorPowerOfTwo:of,setQuaternionFromProperEuler:WS,normalize:lf,denormalize:af},ff=class ff{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};ff.prototype.isVector2=!0;var $t=ff,Ie=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],d=i[s+3],u=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(d!==_||l!==u||c!==f||h!==p){let m=l*u+c*f+h*p+d*_;m<0&&(u=-u,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),b=Math.sin(x);g=Math.sin(g*x)/b,a=Math.sin(a*x)/b,l=l*g+u*a,c=c*g+f*a,h=h*g+p*a,d=d*g+_*a}else{l=l*g+u*a,c=c*g+f*a,h=h*g+p*a,d=d*g+_*a;let x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],d=r[o],u=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*d+l*f-c*u,t[e+1]=l*p+h*u+c*d-a*f,t[e+2]=c*p+h*f+a*u-l*d,t[e+3]=h*p-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),d=a(r/2),u=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"YXZ":this._x=u*h*d+c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"ZXY":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d-u*f*p;break;case"ZYX":this._x=u*h*d-c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d+u*f*p;break;case"YZX":this._x=u*h*d+c*f*p,this._y=c*f*d+u*h*p,this._z=c*h*p-u*f*d,this._w=c*h*d-u*f*p;break;case"XZY":this._x=u*h*d-c*f*p,this._y=c*f*d-u*h*p,this._z=c*h*p+u*f*d,this._w=c*h*d+u*f*p;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=i+a+d;if(u>0){let f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},pf=class pf{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Im.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Im.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),d=2*(r*i-o*e);return this.x=e+l*c+o*d-a*h,this.y=i+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return ed.copy(this).projectOnVector(t),this.sub(ed)}reflect(t){return this.sub(ed.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};pf.prototype.isVector3=!0;var R=pf,ed=new R,Im=new Ie,mf=class mf{constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],d=i[7],u=i[2],f=i[5],p=i[8],_=s[0],m=s[3],g=s[6],x=s[1],b=s[4],v=s[7],C=s[2],E=s[5],y=s[8];return r[0]=o*_+a*x+l*C,r[3]=o*m+a*b+l*E,r[6]=o*g+a*v+l*y,r[1]=c*_+h*x+d*C,r[4]=c*m+h*b+d*E,r[7]=c*g+h*v+d*y,r[2]=u*_+f*x+p*C,r[5]=u*m+f*b+p*E,r[8]=u*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,p=e*d+i*u+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=d*_,t[1]=(s*c-h*i)*_,t[2]=(a*i-s*o)*_,t[3]=u*_,t[4]=(h*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Ba("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(nd.makeScale(t,e)),this}rotate(t){return Ba("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(nd.makeRotation(-t)),this}translate(t,e){return Ba("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(nd.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};mf.prototype.isMatrix3=!0;var se=mf,nd=new se,Lm=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Dm=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function XS(){let n={enabled:!0,workingColorSpace:Ga,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pe&&(s.r=Bs(s.r),s.g=Bs(s.g),s.b=Bs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pe&&(s.r=Bo(s.r),s.g=Bo(s.g),s.b=Bo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===$s?Va:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Ga]:{primaries:t,whitePoint:i,transfer:Va,toXYZ:Lm,fromXYZ:Dm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:vi},outputColorSpaceConfig:{drawingBufferColorSpace:vi}},[vi]:{primaries:t,whitePoint:i,transfer:Pe,toXYZ:Lm,fromXYZ:Dm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:vi}}}),n}var ve=XS();function Bs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Bo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var So,Lc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{So===void 0&&(So=Ha("canvas")),So.width=t.width,So.height=t.height;let s=So.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=So}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ha("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Bs(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Bs(e[i]/255)*255):e[i]=Bs(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},$S=0,Ho=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:$S++}),this.uuid=br(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(id(s[o].image)):r.push(id(s[o]))}else r=id(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function id(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Lc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var YS=0,sd=new R,hi=class n extends ji{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=fs,s=fs,r=ri,o=Ws,a=Qi,l=di,c=n.DEFAULT_ANISOTROPY,h=$s){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:YS++}),this.uuid=br(),this.name="",this.source=new Ho(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new $t(0,0),this.repeat=new $t(1,1),this.center=new $t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(sd).x}get height(){return this.source.getSize(sd).y}get depth(){return this.source.getSize(sd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Xd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Rc:t.x=t.x-Math.floor(t.x);break;case fs:t.x=t.x<0?0:1;break;case Pc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Rc:t.y=t.y-Math.floor(t.y);break;case fs:t.y=t.y<0?0:1;break;case Pc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};hi.DEFAULT_IMAGE=null;hi.DEFAULT_MAPPING=Xd;hi.DEFAULT_ANISOTROPY=1;var gf=class gf{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,v=(f+1)/2,C=(g+1)/2,E=(h+u)/4,y=(d+_)/4,w=(p+m)/4;return b>v&&b>C?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=E/i,r=y/i):v>C?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=E/s,r=w/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=y/r,s=w/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(d-_)*(d-_)+(u-h)*(u-h));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(d-_)/x,this.z=(u-h)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};gf.prototype.isVector4=!0;var Le=gf,Dc=class extends ji{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ri,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Le(0,0,t,e),this.scissorTest=!1,this.viewport=new Le(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new hi({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ri,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ho(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wi=class extends Dc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Xa=class extends hi{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nc=class extends hi{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Gn,this.minFilter=Gn,this.wrapR=fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var th=class th{constructor(t,e,i,s,r,o,a,l,c,h,d,u,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,d,u,f,p,_,m)}set(t,e,i,s,r,o,a,l,c,h,d,u,f,p,_,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=u,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new th().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/bo.setFromMatrixColumn(t,0).length(),r=1/bo.setFromMatrixColumn(t,1).length(),o=1/bo.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){let u=o*h,f=o*d,p=a*h,_=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+p*c,e[5]=u-_*c,e[9]=-a*l,e[2]=_-u*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let u=l*h,f=l*d,p=c*h,_=c*d;e[0]=u+_*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=_+u*a,e[10]=o*l}else if(t.order==="ZXY"){let u=l*h,f=l*d,p=c*h,_=c*d;e[0]=u-_*a,e[4]=-o*d,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=_-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let u=o*h,f=o*d,p=a*h,_=a*d;e[0]=l*h,e[4]=p*c-f,e[8]=u*c+_,e[1]=l*d,e[5]=_*c+u,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let u=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*h,e[4]=_-u*d,e[8]=p*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+p,e[10]=u-_*d}else if(t.order==="XZY"){let u=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+_,e[5]=o*h,e[9]=f*d-p,e[2]=p*d-f,e[6]=a*h,e[10]=_*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(qS,t,ZS)}lookAt(t,e,i){let s=this.elements;return xi.subVectors(t,e),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),or.crossVectors(i,xi),or.lengthSq()===0&&(Math.abs(i.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),or.crossVectors(i,xi)),or.normalize(),Yl.crossVectors(xi,or),s[0]=or.x,s[4]=Yl.x,s[8]=xi.x,s[1]=or.y,s[5]=Yl.y,s[9]=xi.y,s[2]=or.z,s[6]=Yl.z,s[10]=xi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],d=i[5],u=i[9],f=i[13],p=i[2],_=i[6],m=i[10],g=i[14],x=i[3],b=i[7],v=i[11],C=i[15],E=s[0],y=s[4],w=s[8],I=s[12],P=s[1],D=s[5],F=s[9],z=s[13],O=s[2],G=s[6],q=s[10],V=s[14],ot=s[3],$=s[7],K=s[11],et=s[15];return r[0]=o*E+a*P+l*O+c*ot,r[4]=o*y+a*D+l*G+c*$,r[8]=o*w+a*F+l*q+c*K,r[12]=o*I+a*z+l*V+c*et,r[1]=h*E+d*P+u*O+f*ot,r[5]=h*y+d*D+u*G+f*$,r[9]=h*w+d*F+u*q+f*K,r[13]=h*I+d*z+u*V+f*et,r[2]=p*E+_*P+m*O+g*ot,r[6]=p*y+_*D+m*G+g*$,r[10]=p*w+_*F+m*q+g*K,r[14]=p*I+_*z+m*V+g*et,r[3]=x*E+b*P+v*O+C*ot,r[7]=x*y+b*D+v*G+C*$,r[11]=x*w+b*F+v*q+C*K,r[15]=x*I+b*z+v*V+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],p=t[3],_=t[7],m=t[11],g=t[15],x=l*f-c*u,b=a*f-c*d,v=a*u-l*d,C=o*f-c*h,E=o*u-l*h,y=o*d-a*h;return e*(_*x-m*b+g*v)-i*(p*x-m*C+g*E)+s*(p*b-_*C+g*y)-r*(p*v-_*E+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],p=t[12],_=t[13],m=t[14],g=t[15],x=e*a-i*o,b=e*l-s*o,v=e*c-r*o,C=i*l-s*a,E=i*c-r*a,y=s*c-r*l,w=h*_-d*p,I=h*m-u*p,P=h*g-f*p,D=d*m-u*_,F=d*g-f*_,z=u*g-f*m,O=x*z-b*F+v*D+C*P-E*I+y*w;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/O;return t[0]=(a*z-l*F+c*D)*G,t[1]=(s*F-i*z-r*D)*G,t[2]=(_*y-m*E+g*C)*G,t[3]=(u*E-d*y-f*C)*G,t[4]=(l*P-o*z-c*I)*G,t[5]=(e*z-s*P+r*I)*G,t[6]=(m*v-p*y-g*b)*G,t[7]=(h*y-u*v+f*b)*G,t[8]=(o*F-a*P+c*w)*G,t[9]=(i*P-e*F-r*w)*G,t[10]=(p*E-_*v+g*x)*G,t[11]=(d*v-h*E-f*x)*G,t[12]=(a*I-o*D-l*w)*G,t[13]=(e*D-i*I+s*w)*G,t[14]=(_*b-p*C-m*x)*G,t[15]=(h*C-d*b+u*x)*G,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,p=r*d,_=o*h,m=o*d,g=a*d,x=l*c,b=l*h,v=l*d,C=i.x,E=i.y,y=i.z;return s[0]=(1-(_+g))*C,s[1]=(f+v)*C,s[2]=(p-b)*C,s[3]=0,s[4]=(f-v)*E,s[5]=(1-(u+g))*E,s[6]=(m+x)*E,s[7]=0,s[8]=(p+b)*y,s[9]=(m-x)*y,s[10]=(1-(u+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=bo.set(s[0],s[1],s[2]).length(),a=bo.set(s[4],s[5],s[6]).length(),l=bo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Yi.copy(this);let c=1/o,h=1/a,d=1/l;return Yi.elements[0]*=c,Yi.elements[1]*=c,Yi.elements[2]*=c,Yi.elements[4]*=h,Yi.elements[5]*=h,Yi.elements[6]*=h,Yi.elements[8]*=d,Yi.elements[9]*=d,Yi.elements[10]*=d,e.setFromRotationMatrix(Yi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Ni,l=!1){let c=this.elements,h=2*r/(e-t),d=2*r/(i-s),u=(e+t)/(e-t),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===Ni)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===zo)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Ni,l=!1){let c=this.elements,h=2/(e-t),d=2/(i-s),u=-(e+t)/(e-t),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===Ni)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===zo)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};th.prototype.isMatrix4=!0;var Kt=th,bo=new R,Yi=new Kt,qS=new R(0,0,0),ZS=new R(1,1,1),or=new R,Yl=new R,xi=new R,Nm=new Kt,Om=new Ie,Oi=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ce(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Nm.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Nm,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Om.setFromEuler(this),this.setFromQuaternion(Om,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Oi.DEFAULT_ORDER="XYZ";var Wo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},jS=0,Um=new R,wo=new Ie,Ls=new Kt,ql=new R,Ia=new R,JS=new R,KS=new Ie,Fm=new R(1,0,0),Bm=new R(0,1,0),km=new R(0,0,1),zm={type:"added"},QS={type:"removed"},Mo={type:"childadded",child:null},rd={type:"childremoved",child:null},un=class n extends ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:jS++}),this.uuid=br(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new R,e=new Oi,i=new Ie,s=new R(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Kt},normalMatrix:{value:new se}}),this.matrix=new Kt,this.matrixWorld=new Kt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return wo.setFromAxisAngle(t,e),this.quaternion.multiply(wo),this}rotateOnWorldAxis(t,e){return wo.setFromAxisAngle(t,e),this.quaternion.premultiply(wo),this}rotateX(t){return this.rotateOnAxis(Fm,t)}rotateY(t){return this.rotateOnAxis(Bm,t)}rotateZ(t){return this.rotateOnAxis(km,t)}translateOnAxis(t,e){return Um.copy(t).applyQuaternion(this.quaternion),this.position.add(Um.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Fm,t)}translateY(t){return this.translateOnAxis(Bm,t)}translateZ(t){return this.translateOnAxis(km,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ls.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ql.copy(t):ql.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ia.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ls.lookAt(Ia,ql,this.up):Ls.lookAt(ql,Ia,this.up),this.quaternion.setFromRotationMatrix(Ls),s&&(Ls.extractRotation(s.matrixWorld),wo.setFromRotationMatrix(Ls),this.quaternion.premultiply(wo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ee("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(zm),Mo.child=t,this.dispatchEvent(Mo),Mo.child=null):ee("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(QS),rd.child=t,this.dispatchEvent(rd),rd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ls.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ls.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ls),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(zm),Mo.child=t,this.dispatchEvent(Mo),Mo.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ia,t,JS),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ia,KS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),u.length>0&&(i.skeletons=u),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};un.DEFAULT_UP=new R(0,1,0);un.DEFAULT_MATRIX_AUTO_UPDATE=!0;un.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Te=class extends un{constructor(){super(),this.isGroup=!0,this.type="Group"}},tb={type:"move"},Xo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Te,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Te,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new R,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new R),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Te,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new R,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new R,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&u>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(tb)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Te;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},$g={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ar={h:0,s:0,l:0},Zl={h:0,s:0,l:0};function od(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Zt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=vi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ve.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=ve.workingColorSpace){return this.r=t,this.g=e,this.b=i,ve.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=ve.workingColorSpace){if(t=rf(t,1),e=ce(e,0,1),i=ce(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=od(o,r,t+1/3),this.g=od(o,r,t),this.b=od(o,r,t-1/3)}return ve.colorSpaceToWorking(this,s),this}setStyle(t,e=vi){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=vi){let i=$g[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Bs(t.r),this.g=Bs(t.g),this.b=Bs(t.b),this}copyLinearToSRGB(t){return this.r=Bo(t.r),this.g=Bo(t.g),this.b=Bo(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=vi){return ve.workingToColorSpace(jn.copy(this),t),Math.round(ce(jn.r*255,0,255))*65536+Math.round(ce(jn.g*255,0,255))*256+Math.round(ce(jn.b*255,0,255))}getHexString(t=vi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ve.workingColorSpace){ve.workingToColorSpace(jn.copy(this),e);let i=jn.r,s=jn.g,r=jn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=ve.workingColorSpace){return ve.workingToColorSpace(jn.copy(this),e),t.r=jn.r,t.g=jn.g,t.b=jn.b,t}getStyle(t=vi){ve.workingToColorSpace(jn.copy(this),t);let e=jn.r,i=jn.g,s=jn.b;return t!==vi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(ar),this.setHSL(ar.h+t,ar.s+e,ar.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(ar),t.getHSL(Zl);let i=ka(ar.h,Zl.h,e),s=ka(ar.s,Zl.s,e),r=ka(ar.l,Zl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new Zt;Zt.NAMES=$g;var Gr=class extends un{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Oi,this.environmentIntensity=1,this.environmentRotation=new Oi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},qi=new R,Ds=new R,ad=new R,Ns=new R,Eo=new R,Ao=new R,Gm=new R,ld=new R,cd=new R,hd=new R,ud=new Le,dd=new Le,fd=new Le,Fs=class n{constructor(t=new R,e=new R,i=new R){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),qi.subVectors(t,e),s.cross(qi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){qi.subVectors(s,e),Ds.subVectors(i,e),ad.subVectors(t,e);let o=qi.dot(qi),a=qi.dot(Ds),l=qi.dot(ad),c=Ds.dot(Ds),h=Ds.dot(ad),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let u=1/d,f=(c*l-a*h)*u,p=(o*h-a*l)*u;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Ns)===null?!1:Ns.x>=0&&Ns.y>=0&&Ns.x+Ns.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Ns)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ns.x),l.addScaledVector(o,Ns.y),l.addScaledVector(a,Ns.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return ud.setScalar(0),dd.setScalar(0),fd.setScalar(0),ud.fromBufferAttribute(t,e),dd.fromBufferAttribute(t,i),fd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(ud,r.x),o.addScaledVector(dd,r.y),o.addScaledVector(fd,r.z),o}static isFrontFacing(t,e,i,s){return qi.subVectors(i,e),Ds.subVectors(t,e),qi.cross(Ds).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return qi.subVectors(this.c,this.b),Ds.subVectors(this.a,this.b),qi.cross(Ds).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Eo.subVectors(s,i),Ao.subVectors(r,i),ld.subVectors(t,i);let l=Eo.dot(ld),c=Ao.dot(ld);if(l<=0&&c<=0)return e.copy(i);cd.subVectors(t,s);let h=Eo.dot(cd),d=Ao.dot(cd);if(h>=0&&d<=h)return e.copy(s);let u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(Eo,o);hd.subVectors(t,r);let f=Eo.dot(hd),p=Ao.dot(hd);if(p>=0&&f<=p)return e.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Ao,a);let m=h*p-f*d;if(m<=0&&d-h>=0&&f-p>=0)return Gm.subVectors(r,s),a=(d-h)/(d-h+(f-p)),e.copy(s).addScaledVector(Gm,a);let g=1/(m+_+u);return o=_*g,a=u*g,e.copy(i).addScaledVector(Eo,o).addScaledVector(Ao,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},tn=class{constructor(t=new R(1/0,1/0,1/0),e=new R(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Zi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Zi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Zi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Zi):Zi.fromBufferAttribute(r,o),Zi.applyMatrix4(t.matrixWorld),this.expandByPoint(Zi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),jl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),jl.copy(i.boundingBox)),jl.applyMatrix4(t.matrixWorld),this.union(jl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Zi),Zi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(La),Jl.subVectors(this.max,La),To.subVectors(t.a,La),Co.subVectors(t.b,La),Ro.subVectors(t.c,La),lr.subVectors(Co,To),cr.subVectors(Ro,Co),Fr.subVectors(To,Ro);let e=[0,-lr.z,lr.y,0,-cr.z,cr.y,0,-Fr.z,Fr.y,lr.z,0,-lr.x,cr.z,0,-cr.x,Fr.z,0,-Fr.x,-lr.y,lr.x,0,-cr.y,cr.x,0,-Fr.y,Fr.x,0];return!pd(e,To,Co,Ro,Jl)||(e=[1,0,0,0,1,0,0,0,1],!pd(e,To,Co,Ro,Jl))?!1:(Kl.crossVectors(lr,cr),e=[Kl.x,Kl.y,Kl.z],pd(e,To,Co,Ro,Jl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Zi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Zi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Os),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Os=[new R,new R,new R,new R,new R,new R,new R,new R],Zi=new R,jl=new tn,To=new R,Co=new R,Ro=new R,lr=new R,cr=new R,Fr=new R,La=new R,Jl=new R,Kl=new R,Br=new R;function pd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Br.fromArray(n,r);let a=s.x*Math.abs(Br.x)+s.y*Math.abs(Br.y)+s.z*Math.abs(Br.z),l=t.dot(Br),c=e.dot(Br),h=i.dot(Br);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var An=new R,Ql=new $t,eb=0,hn=class extends ji{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:eb++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=ef,this.updateRanges=[],this.gpuType=zi,this.version=0,this._normalizationScale=t!==void 0?Vh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Ql.fromBufferAttribute(this,e),Ql.applyMatrix3(t),this.setXY(e,Ql.x,Ql.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.applyMatrix3(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.applyMatrix4(t),this.setXYZ(e,An.x,An.y,An.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.applyNormalMatrix(t),this.setXYZ(e,An.x,An.y,An.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)An.fromBufferAttribute(this,e),An.transformDirection(t),this.setXYZ(e,An.x,An.y,An.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):af(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):lf(t,this.array)}};var $a=class extends hn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Ya=class extends hn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ie=class extends hn{constructor(t,e,i){super(new Float32Array(t),e,i)}},nb=new tn,Da=new R,md=new R,Mi=class{constructor(t=new R,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):nb.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Da.subVectors(t,this.center);let e=Da.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Da,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(md.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Da.copy(t.center).add(md)),this.expandByPoint(Da.copy(t.center).sub(md))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},ib=0,Di=new Kt,gd=new un,Po=new R,yi=new tn,Na=new tn,zn=new R,Me=class n extends ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ib++}),this.uuid=br(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(CS(t)?Ya:$a)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new se().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Di.makeRotationFromQuaternion(t),this.applyMatrix4(Di),this}rotateX(t){return Di.makeRotationX(t),this.applyMatrix4(Di),this}rotateY(t){return Di.makeRotationY(t),this.applyMatrix4(Di),this}rotateZ(t){return Di.makeRotationZ(t),this.applyMatrix4(Di),this}translate(t,e,i){return Di.makeTranslation(t,e,i),this.applyMatrix4(Di),this}scale(t,e,i){return Di.makeScale(t,e,i),this.applyMatrix4(Di),this}lookAt(t){return gd.lookAt(t),gd.updateMatrix(),this.applyMatrix4(gd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Po).negate(),this.translate(Po.x,Po.y,Po.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ie(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new R(-1/0,-1/0,-1/0),new R(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];yi.setFromBufferAttribute(r),this.morphTargetsRelative?(zn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(zn),zn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(zn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ee('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Mi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new R,1/0);return}if(t){let i=this.boundingSphere.center;if(yi.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Na.setFromBufferAttribute(a),this.morphTargetsRelative?(zn.addVectors(yi.min,Na.min),yi.expandByPoint(zn),zn.addVectors(yi.max,Na.max),yi.expandByPoint(zn)):(yi.expandByPoint(Na.min),yi.expandByPoint(Na.max))}yi.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)zn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(zn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)zn.fromBufferAttribute(a,c),l&&(Po.fromBufferAttribute(t,c),zn.add(Po)),s=Math.max(s,i.distanceToSquared(zn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ee('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ee("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new hn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new R,l[I]=new R;let h=new R,d=new R,u=new R,f=new $t,p=new $t,_=new $t,m=new R,g=new R;function x(I,P,D){c[I]=c[P]=c[D]=1,h.fromBufferAttribute(i,I),d.fromBufferAttribute(i,P),u.fromBufferAttribute(i,D),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,P),_.fromBufferAttribute(r,D),d.sub(h),u.sub(h),p.sub(f),_.sub(f);let F=1/(p.x*_.y-_.x*p.y);isFinite(F)&&(m.copy(d).multiplyScalar(_.y).addScaledVector(u,-p.y).multiplyScalar(F),g.copy(u).multiplyScalar(p.x).addScaledVector(d,-_.x).multiplyScalar(F),a[I].add(m),a[P].add(m),a[D].add(m),l[I].add(g),l[P].add(g),l[D].add(g))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let I=0,P=b.length;I<P;++I){let D=b[I],F=D.start,z=D.count;for(let O=F,G=F+z;O<G;O+=3)x(t.getX(O+0),t.getX(O+1),t.getX(O+2))}let v=new R,C=new R,E=new R,y=new R;function w(I){E.fromBufferAttribute(s,I),y.copy(E);let P=a[I];v.copy(P),v.sub(E.multiplyScalar(E.dot(P))).normalize(),C.crossVectors(y,P);let F=C.dot(l[I])<0?-1:1;o.setXYZW(I,v.x,v.y,v.z,F)}for(let I=0,P=i.count;I<P;++I)c[I]&&w(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new hn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let u=0,f=i.count;u<f;u++)i.setXYZ(u,0,0,0);let s=new R,r=new R,o=new R,a=new R,l=new R,c=new R,h=new R,d=new R;if(t)for(let u=0,f=t.count;u<f;u+=3){let p=t.getX(u+0),_=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),i.setXYZ(u+0,h.x,h.y,h.z),i.setXYZ(u+1,h.x,h.y,h.z),i.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)zn.fromBufferAttribute(t,e),zn.normalize(),t.setXYZ(e,zn.x,zn.y,zn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*h;for(let g=0;g<h;g++)u[p++]=c[f++]}return new hn(u,h,d)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){let u=c[h],f=t(u,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){let f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},qa=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=ef,this.updateRanges=[],this.version=0,this.uuid=br()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Vm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Vm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Vm(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=br()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var si=new R,Ui=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Vh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)si.fromBufferAttribute(this,e),si.applyMatrix4(t),this.setXYZ(e,si.x,si.y,si.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)si.fromBufferAttribute(this,e),si.applyNormalMatrix(t),this.setXYZ(e,si.x,si.y,si.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)si.fromBufferAttribute(this,e),si.transformDirection(t),this.setXYZ(e,si.x,si.y,si.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Wa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new hn(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Wa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):af(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):lf(t,this.data.array)}},_d=new R,sb=new R,rb=new se,Si=class{constructor(t=new R(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=_d.subVectors(i,e).cross(sb.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(_d),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||rb.getNormalMatrix(t),s=this.coplanarPoint(_d).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},ob=0,ps=class extends ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ob++}),this.uuid=br(),this.name="",this.type="Material",this.blending=Jo,this.side=vr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Ud,this.blendDst=Fd,this.blendEquation=Zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Zt(0,0,0),this.blendAlpha=0,this.depthFunc=ko,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ug,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Sc,this.stencilZFail=Sc,this.stencilZPass=Sc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Si().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new $t().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new $t().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Us=new R,xd=new R,tc=new R,ec=new R,ur=class{constructor(t=new R,e=new R(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Us)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Us.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Us.copy(this.origin).addScaledVector(this.direction,e),Us.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){xd.copy(t).add(e).multiplyScalar(.5),tc.copy(e).sub(t).normalize(),ec.copy(this.origin).sub(xd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(tc),a=ec.dot(this.direction),l=-ec.dot(tc),c=ec.lengthSq(),h=Math.abs(1-o*o),d,u,f,p;if(h>0)if(d=o*l-a,u=o*a-l,p=r*h,d>=0)if(u>=-p)if(u<=p){let _=1/h;d*=_,u*=_,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-p?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=p?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(xd).addScaledVector(tc,u),f}intersectSphere(t,e){if(t.radius<0)return null;Us.subVectors(t.center,this.origin);let i=Us.dot(this.direction),s=Us.dot(Us)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(i=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(i=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Us)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,p=e.x-o.x,_=e.y-o.y,m=e.z-o.z,g=i.x-o.x,x=i.y-o.y,b=i.z-o.z,v=Math.abs(l),C=Math.abs(c),E=Math.abs(h),y,w,I,P,D,F,z,O,G,q,V,ot;if(v>=C&&v>=E?(I=l,F=d,G=p,ot=g,l>=0?(y=c,w=h,P=u,D=f,z=_,O=m,q=x,V=b):(y=h,w=c,P=f,D=u,z=m,O=_,q=b,V=x)):C>=E?(I=c,F=u,G=_,ot=x,c>=0?(y=h,w=l,P=f,D=d,z=m,O=p,q=b,V=g):(y=l,w=h,P=d,D=f,z=p,O=m,q=g,V=b)):(I=h,F=f,G=m,ot=b,h>=0?(y=l,w=c,P=d,D=u,z=p,O=_,q=g,V=x):(y=c,w=l,P=u,D=d,z=_,O=p,q=x,V=g)),I===0)return null;let $=y/I,K=w/I,et=1/I,ht=P-$*F,ut=D-K*F,Q=z-$*G,gt=O-K*G,yt=q-$*ot,Ct=V-K*ot,wt=yt*gt-Ct*Q,Wt=ht*Ct-ut*yt,ae=Q*ut-gt*ht;if(s){if(wt<0||Wt<0||ae<0)return null}else if((wt<0||Wt<0||ae<0)&&(wt>0||Wt>0||ae>0))return null;let Vt=wt+Wt+ae;if(Vt===0)return null;let me=et*(wt*F+Wt*G+ae*ot);return(Vt>0?me<0:me>0)?null:this.at(me/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},oi=class extends ps{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Oi,this.combine=eh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Hm=new Kt,kr=new ur,nc=new Mi,Wm=new R,ic=new R,sc=new R,rc=new R,yd=new R,oc=new R,Xm=new R,ac=new R,mt=class extends un{constructor(t=new Me,e=new oi){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){oc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],d=r[l];h!==0&&(yd.fromBufferAttribute(d,t),o?oc.addScaledVector(yd,h):oc.addScaledVector(yd.sub(e),h))}e.add(oc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),nc.copy(i.boundingSphere),nc.applyMatrix4(r),kr.copy(t.ray).recast(t.near),!(nc.containsPoint(kr.origin)===!1&&(kr.intersectSphere(nc,Wm)===null||kr.origin.distanceToSquared(Wm)>(t.far-t.near)**2))&&(Hm.copy(r).invert(),kr.copy(t.ray).applyMatrix4(Hm),!(i.boundingBox!==null&&kr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,kr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=u.length;p<_;p++){let m=u[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),b=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,C=b;v<C;v+=3){let E=a.getX(v),y=a.getX(v+1),w=a.getX(v+2);s=lc(this,g,t,i,c,h,d,E,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),b=a.getX(m+1),v=a.getX(m+2);s=lc(this,o,t,i,c,h,d,x,b,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=u.length;p<_;p++){let m=u[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),b=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,C=b;v<C;v+=3){let E=v,y=v+1,w=v+2;s=lc(this,g,t,i,c,h,d,E,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,b=m+1,v=m+2;s=lc(this,o,t,i,c,h,d,x,b,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function ab(n,t,e,i,s,r,o,a){let l;if(t.side===ai?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===vr,a),l===null)return null;ac.copy(a),ac.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ac);return c<e.near||c>e.far?null:{distance:c,point:ac.clone(),object:n}}function lc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ic),n.getVertexPosition(l,sc),n.getVertexPosition(c,rc);let h=ab(n,t,e,i,ic,sc,rc,Xm);if(h){let d=new R;Fs.getBarycoord(Xm,ic,sc,rc,d),s&&(h.uv=Fs.getInterpolatedAttribute(s,a,l,c,d,new $t)),r&&(h.uv1=Fs.getInterpolatedAttribute(r,a,l,c,d,new $t)),o&&(h.normal=Fs.getInterpolatedAttribute(o,a,l,c,d,new R),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let u={a,b:l,c,normal:new R,materialIndex:0};Fs.getNormal(ic,sc,rc,u.normal),h.face=u,h.barycoord=d}return h}var Za=class extends hi{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Gn,h=Gn,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var $o=class extends hn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Io=new Kt,$m=new Kt,cc=[],Ym=new tn,lb=new Kt,Oa=new mt,Ua=new Mi,zs=class extends mt{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new $o(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,lb)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new tn),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Io),Ym.copy(t.boundingBox).applyMatrix4(Io),this.boundingBox.union(Ym)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Mi),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Io),Ua.copy(t.boundingSphere).applyMatrix4(Io),this.boundingSphere.union(Ua)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Oa.geometry=this.geometry,Oa.material=this.material,Oa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ua.copy(this.boundingSphere),Ua.applyMatrix4(i),t.ray.intersectsSphere(Ua)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Io),$m.multiplyMatrices(i,Io),Oa.matrixWorld=$m,Oa.raycast(t,cc);for(let o=0,a=cc.length;o<a;o++){let l=cc[o];l.instanceId=r,l.object=this,e.push(l)}cc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new $o(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Za(new Float32Array(s*this.count),s,this.count,lh,zi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},zr=new Mi,cb=new $t(.5,.5),hc=new R,dr=class{constructor(t=new Si,e=new Si,i=new Si,s=new Si,r=new Si,o=new Si){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Ni,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],b=r[13],v=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,g-p,C-x).normalize(),s[1].setComponents(c+o,f+h,g+p,C+x).normalize(),s[2].setComponents(c+a,f+d,g+_,C+b).normalize(),s[3].setComponents(c-a,f-d,g-_,C-b).normalize(),i)s[4].setComponents(l,u,m,v).normalize(),s[5].setComponents(c-l,f-u,g-m,C-v).normalize();else if(s[4].setComponents(c-l,f-u,g-m,C-v).normalize(),e===Ni)s[5].setComponents(c+l,f+u,g+m,C+v).normalize();else if(e===zo)s[5].setComponents(l,u,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),zr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),zr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(zr)}intersectsSprite(t){zr.center.set(0,0,0);let e=cb.distanceTo(t.center);return zr.radius=.7071067811865476+e,zr.applyMatrix4(t.matrixWorld),this.intersectsSphere(zr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(hc.x=s.normal.x>0?t.max.x:t.min.x,hc.y=s.normal.y>0?t.max.y:t.min.y,hc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(hc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},qm=new Kt,Oc=class n{constructor(){this.coordinateSystem=Ni,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];qm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new dr),i[s].setFromProjectionMatrix(qm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new dr),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Fi=class extends ps{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Zt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Uc=new R,Fc=new R,Zm=new Kt,Fa=new ur,uc=new Mi,vd=new R,jm=new R,Ei=class extends un{constructor(t=new Me,e=new Fi){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Uc.fromBufferAttribute(e,s-1),Fc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Uc.distanceTo(Fc);t.setAttribute("lineDistance",new ie(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),uc.copy(i.boundingSphere),uc.applyMatrix4(s),uc.radius+=r,t.ray.intersectsSphere(uc)===!1)return;Zm.copy(s).invert(),Fa.copy(t.ray).applyMatrix4(Zm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,u=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=h.getX(_),x=h.getX(_+1),b=dc(this,t,Fa,l,g,x,_);b&&e.push(b)}if(this.isLineLoop){let _=h.getX(p-1),m=h.getX(f),g=dc(this,t,Fa,l,_,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=dc(this,t,Fa,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=dc(this,t,Fa,l,p-1,f,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function dc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Uc.fromBufferAttribute(a,s),Fc.fromBufferAttribute(a,r),e.distanceSqToSegment(Uc,Fc,vd,jm)>i)return;vd.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(vd);if(!(c<t.near||c>t.far))return{distance:c,point:jm.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Jm=new R,Km=new R,Gs=class extends Ei{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Jm.fromBufferAttribute(e,s),Km.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Jm.distanceTo(Km);t.setAttribute("lineDistance",new ie(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ja=class extends hi{constructor(t=[],e=jr,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Vs=class extends hi{constructor(t,e,i=Ji,s,r,o,a=Gn,l=Gn,c,h=ks,d=1){if(h!==ks&&h!==Xs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let u={width:t,height:e,depth:d};super(u,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ho(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Ja=class extends Vs{constructor(t,e=Ji,i=jr,s,r,o=Gn,a=Gn,l,c=ks){let h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ka=class extends hi{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ye=class n extends Me{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],d=[],u=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ie(c,3)),this.setAttribute("normal",new ie(h,3)),this.setAttribute("uv",new ie(d,2));function p(_,m,g,x,b,v,C,E,y,w,I){let P=v/y,D=C/w,F=v/2,z=C/2,O=E/2,G=y+1,q=w+1,V=0,ot=0,$=new R;for(let K=0;K<q;K++){let et=K*D-z;for(let ht=0;ht<G;ht++){let ut=ht*P-F;$[_]=ut*x,$[m]=et*b,$[g]=O,c.push($.x,$.y,$.z),$[_]=0,$[m]=0,$[g]=E>0?1:-1,h.push($.x,$.y,$.z),d.push(ht/y),d.push(1-K/w),V+=1}}for(let K=0;K<w;K++)for(let et=0;et<y;et++){let ht=u+et+G*K,ut=u+et+G*(K+1),Q=u+(et+1)+G*(K+1),gt=u+(et+1)+G*K;l.push(ht,ut,gt),l.push(ut,Q,gt),ot+=6}a.addGroup(f,ot,I),f+=ot,u+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Vr=class n extends Me{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=e/2,d=Math.PI/2*t,u=e,f=2*d+u,p=i*2+r,_=s+1,m=new R,g=new R;for(let x=0;x<=p;x++){let b=0,v=0,C=0,E=0;if(x<=i){let I=x/i,P=I*Math.PI/2;v=-h-t*Math.cos(P),C=t*Math.sin(P),E=-t*Math.cos(P),b=I*d}else if(x<=i+r){let I=(x-i)/r;v=-h+I*e,C=t,E=0,b=d+I*u}else{let I=(x-i-r)/i,P=I*Math.PI/2;v=h+t*Math.sin(P),C=t*Math.cos(P),E=t*Math.sin(P),b=d+u+I*d}let y=Math.max(0,Math.min(1,b/f)),w=0;x===0?w=.5/s:x===p&&(w=-.5/s);for(let I=0;I<=s;I++){let P=I/s,D=P*Math.PI*2,F=Math.sin(D),z=Math.cos(D);g.x=-C*z,g.y=v,g.z=C*F,a.push(g.x,g.y,g.z),m.set(-C*z,E,C*F),m.normalize(),l.push(m.x,m.y,m.z),c.push(P+w,y)}if(x>0){let I=(x-1)*_;for(let P=0;P<s;P++){let D=I+P,F=I+P+1,z=x*_+P,O=x*_+P+1;o.push(D,F,z),o.push(F,O,z)}}}this.setIndex(o),this.setAttribute("position",new ie(a,3)),this.setAttribute("normal",new ie(l,3)),this.setAttribute("uv",new ie(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}};var Ge=class n extends Me{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],d=[],u=[],f=[],p=0,_=[],m=i/2,g=0;x(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(h),this.setAttribute("position",new ie(d,3)),this.setAttribute("normal",new ie(u,3)),this.setAttribute("uv",new ie(f,2));function x(){let v=new R,C=new R,E=0,y=(e-t)/i;for(let w=0;w<=r;w++){let I=[],P=w/r,D=P*(e-t)+t;for(let F=0;F<=s;F++){let z=F/s,O=z*l+a,G=Math.sin(O),q=Math.cos(O);C.x=D*G,C.y=-P*i+m,C.z=D*q,d.push(C.x,C.y,C.z),v.set(G,y,q).normalize(),u.push(v.x,v.y,v.z),f.push(z,1-P),I.push(p++)}_.push(I)}for(let w=0;w<s;w++)for(let I=0;I<r;I++){let P=_[I][w],D=_[I+1][w],F=_[I+1][w+1],z=_[I][w+1];(t>0||I!==0)&&(h.push(P,D,z),E+=3),(e>0||I!==r-1)&&(h.push(D,F,z),E+=3)}c.addGroup(g,E,0),g+=E}function b(v){let C=p,E=new $t,y=new R,w=0,I=v===!0?t:e,P=v===!0?1:-1;for(let F=1;F<=s;F++)d.push(0,m*P,0),u.push(0,P,0),f.push(.5,.5),p++;let D=p;for(let F=0;F<=s;F++){let O=F/s*l+a,G=Math.cos(O),q=Math.sin(O);y.x=I*q,y.y=m*P,y.z=I*G,d.push(y.x,y.y,y.z),u.push(0,P,0),E.x=G*.5+.5,E.y=q*.5*P+.5,f.push(E.x,E.y),p++}for(let F=0;F<s;F++){let z=C+F,O=D+F;v===!0?h.push(O,O+1,z):h.push(O+1,O,z),w+=3}c.addGroup(g,w,v===!0?1:2),g+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Bi=class n extends Ge{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Bc=class n extends Me{constructor(t=[],e=[],i=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:i,detail:s};let r=[],o=[];a(s),c(i),h(),this.setAttribute("position",new ie(r,3)),this.setAttribute("normal",new ie(r.slice(),3)),this.setAttribute("uv",new ie(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(x){let b=new R,v=new R,C=new R;for(let E=0;E<e.length;E+=3)f(e[E+0],b),f(e[E+1],v),f(e[E+2],C),l(b,v,C,x)}function l(x,b,v,C){let E=C+1,y=[];for(let w=0;w<=E;w++){y[w]=[];let I=x.clone().lerp(v,w/E),P=b.clone().lerp(v,w/E),D=E-w;for(let F=0;F<=D;F++)F===0&&w===E?y[w][F]=I:y[w][F]=I.clone().lerp(P,F/D)}for(let w=0;w<E;w++)for(let I=0;I<2*(E-w)-1;I++){let P=Math.floor(I/2);I%2===0?(u(y[w][P+1]),u(y[w+1][P]),u(y[w][P])):(u(y[w][P+1]),u(y[w+1][P+1]),u(y[w+1][P]))}}function c(x){let b=new R;for(let v=0;v<r.length;v+=3)b.x=r[v+0],b.y=r[v+1],b.z=r[v+2],b.normalize().multiplyScalar(x),r[v+0]=b.x,r[v+1]=b.y,r[v+2]=b.z}function h(){let x=new R;for(let b=0;b<r.length;b+=3){x.x=r[b+0],x.y=r[b+1],x.z=r[b+2];let v=m(x)/2/Math.PI+.5,C=g(x)/Math.PI+.5;o.push(v,1-C)}p(),d()}function d(){for(let x=0;x<o.length;x+=6){let b=o[x+0],v=o[x+2],C=o[x+4],E=Math.max(b,v,C),y=Math.min(b,v,C);E>.9&&y<.1&&(b<.2&&(o[x+0]+=1),v<.2&&(o[x+2]+=1),C<.2&&(o[x+4]+=1))}}function u(x){r.push(x.x,x.y,x.z)}function f(x,b){let v=x*3;b.x=t[v+0],b.y=t[v+1],b.z=t[v+2]}function p(){let x=new R,b=new R,v=new R,C=new R,E=new $t,y=new $t,w=new $t;for(let I=0,P=0;I<r.length;I+=9,P+=6){x.set(r[I+0],r[I+1],r[I+2]),b.set(r[I+3],r[I+4],r[I+5]),v.set(r[I+6],r[I+7],r[I+8]),E.set(o[P+0],o[P+1]),y.set(o[P+2],o[P+3]),w.set(o[P+4],o[P+5]),C.copy(x).add(b).add(v).divideScalar(3);let D=m(C);_(E,P+0,x,D),_(y,P+2,b,D),_(w,P+4,v,D)}}function _(x,b,v,C){C<0&&x.x===1&&(o[b]=x.x-1),v.x===0&&v.z===0&&(o[b]=C/2/Math.PI+.5)}function m(x){return Math.atan2(x.z,-x.x)}function g(x){return Math.atan2(-x.y,Math.sqrt(x.x*x.x+x.z*x.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.vertices,t.indices,t.radius,t.detail)}};var fc=new R,pc=new R,Sd=new R,mc=new Fs,Qa=class extends Me{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Fo*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],d=new Array(3),u=new Map,f=[];for(let p=0;p<l;p+=3){o?(c[0]=o.getX(p),c[1]=o.getX(p+1),c[2]=o.getX(p+2)):(c[0]=p,c[1]=p+1,c[2]=p+2);let{a:_,b:m,c:g}=mc;if(_.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),g.fromBufferAttribute(a,c[2]),mc.getNormal(Sd),d[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,d[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,d[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(d[0]===d[1]||d[1]===d[2]||d[2]===d[0]))for(let x=0;x<3;x++){let b=(x+1)%3,v=d[x],C=d[b],E=mc[h[x]],y=mc[h[b]],w=`${v}_${C}`,I=`${C}_${v}`,P=u.get(I);P?(Sd.dot(P.normal)<=r&&(f.push(E.x,E.y,E.z),f.push(y.x,y.y,y.z)),u.set(I,null)):u.has(w)||u.set(w,{index0:c[x],index1:c[b],normal:Sd.clone()})}}for(let p of u.values())if(p){let{index0:_,index1:m}=p;fc.fromBufferAttribute(a,_),pc.fromBufferAttribute(a,m),f.push(fc.x,fc.y,fc.z),f.push(pc.x,pc.y,pc.z)}this.setAttribute("position",new ie(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var fr=class n extends Bc{constructor(t=1,e=0){let i=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(i,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new n(t.radius,t.detail)}},Hr=class n extends Me{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,f=[],p=[],_=[],m=[];for(let g=0;g<h;g++){let x=g*u-o;for(let b=0;b<c;b++){let v=b*d-r;p.push(v,-x,0),_.push(0,0,1),m.push(b/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let b=x+c*g,v=x+c*(g+1),C=x+1+c*(g+1),E=x+1+c*g;f.push(b,v,E),f.push(v,C,E)}this.setIndex(f),this.setAttribute("position",new ie(p,3)),this.setAttribute("normal",new ie(_,3)),this.setAttribute("uv",new ie(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}},Wr=class n extends Me{constructor(t=.5,e=1,i=32,s=1,r=0,o=Math.PI*2){super(),this.type="RingGeometry",this.parameters={innerRadius:t,outerRadius:e,thetaSegments:i,phiSegments:s,thetaStart:r,thetaLength:o},i=Math.max(3,i),s=Math.max(1,s);let a=[],l=[],c=[],h=[],d=t,u=(e-t)/s,f=new R,p=new $t;for(let _=0;_<=s;_++){for(let m=0;m<=i;m++){let g=r+m/i*o;f.x=d*Math.cos(g),f.y=d*Math.sin(g),l.push(f.x,f.y,f.z),c.push(0,0,1),p.x=(f.x/e+1)/2,p.y=(f.y/e+1)/2,h.push(p.x,p.y)}d+=u}for(let _=0;_<s;_++){let m=_*(i+1);for(let g=0;g<i;g++){let x=g+m,b=x,v=x+i+1,C=x+i+2,E=x+1;a.push(b,v,E),a.push(v,C,E)}}this.setIndex(a),this.setAttribute("position",new ie(l,3)),this.setAttribute("normal",new ie(c,3)),this.setAttribute("uv",new ie(h,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.innerRadius,t.outerRadius,t.thetaSegments,t.phiSegments,t.thetaStart,t.thetaLength)}};var ui=class n extends Me{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],d=new R,u=new R,f=[],p=[],_=[],m=[];for(let g=0;g<=i;g++){let x=[],b=g/i,v=o+b*a,C=t*Math.cos(v),E=Math.sqrt(t*t-C*C),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let w=0;w<=e;w++){let I=w/e,P=s+I*r;d.x=-E*Math.cos(P),d.y=C,d.z=E*Math.sin(P),p.push(d.x,d.y,d.z),u.copy(d).normalize(),_.push(u.x,u.y,u.z),m.push(I+y,1-b),x.push(c++)}h.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let b=h[g][x+1],v=h[g][x],C=h[g+1][x],E=h[g+1][x+1];(g!==0||o>0)&&f.push(b,v,E),(g!==i-1||l<Math.PI)&&f.push(v,C,E)}this.setIndex(f),this.setAttribute("position",new ie(p,3)),this.setAttribute("normal",new ie(_,3)),this.setAttribute("uv",new ie(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ai=class n extends Me{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],h=[],d=[],u=new R,f=new R,p=new R;for(let _=0;_<=i;_++){let m=o+_/i*a;for(let g=0;g<=s;g++){let x=g/s*r;f.x=(t+e*Math.cos(m))*Math.cos(x),f.y=(t+e*Math.cos(m))*Math.sin(x),f.z=e*Math.sin(m),c.push(f.x,f.y,f.z),u.x=t*Math.cos(x),u.y=t*Math.sin(x),p.subVectors(f,u).normalize(),h.push(p.x,p.y,p.z),d.push(g/s),d.push(_/i)}}for(let _=1;_<=i;_++)for(let m=1;m<=s;m++){let g=(s+1)*_+m-1,x=(s+1)*(_-1)+m-1,b=(s+1)*(_-1)+m,v=(s+1)*_+m;l.push(g,x,v),l.push(x,b,v)}this.setIndex(l),this.setAttribute("position",new ie(c,3)),this.setAttribute("normal",new ie(h,3)),this.setAttribute("uv",new ie(d,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};var tl=class extends Me{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,s=new R,r=new R;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let d=l[c],u=d.start,f=d.count;for(let p=u,_=u+f;p<_;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),x=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,x),Qm(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,d),Qm(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new ie(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function Qm(n,t,e){let i=`${n.x},${n.y},${n.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${n.x},${n.y},${n.z}`;return e.has(i)===!0||e.has(s)===!0?!1:(e.add(i),e.add(s),!0)}function Kr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(tg(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(tg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Kn(n){let t={};for(let e=0;e<n.length;e++){let i=Kr(n[e]);for(let s in i)t[s]=i[s]}return t}function tg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function hb(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function cf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ve.workingColorSpace}var _l={clone:Kr,merge:Kn},ub=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,db=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ki=class extends ps{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ub,this.fragmentShader=db,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Kr(t.uniforms),this.uniformsGroups=hb(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Zt().setHex(s.value);break;case"v2":this.uniforms[i].value=new $t().fromArray(s.value);break;case"v3":this.uniforms[i].value=new R().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Le().fromArray(s.value);break;case"m3":this.uniforms[i].value=new se().fromArray(s.value);break;case"m4":this.uniforms[i].value=new Kt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},kc=class extends ki{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},el=class extends ps{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Zt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=gl,this.normalScale=new $t(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Oi,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Jn=class extends ps{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=gl,this.normalScale=new $t(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Oi,this.combine=eh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},zc=class extends ps{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ng,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Gc=class extends ps{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Lo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function gc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var pr=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Vc=class extends pr{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ed,endingEnd:Ed}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ad:r=t,a=2*e-i;break;case Td:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Ad:o=t,l=2*i-e;break;case Td:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,u=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),_=p*p,m=_*p,g=-u*m+2*u*_-u*p,x=(1+u)*m+(-1.5-2*u)*_+(-.5+u)*p+1,b=(-1-f)*m+(1.5+f)*_+.5*p,v=f*m-f*_;for(let C=0;C!==a;++C)r[C]=g*o[h+C]+x*o[c+C]+b*o[l+C]+v*o[d+C];return r}},Hc=class extends pr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),d=1-h;for(let u=0;u!==a;++u)r[u]=o[c+u]*d+o[l+u]*h;return r}},Wc=class extends pr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Xc=class extends pr{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let p=(i-e)/(s-e),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let u=a*2,f=t-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*u+p*2,x=d[g],b=d[g+1],v=t*u+p*2,C=h[v],E=h[v+1],y=pb(i,e,x,C,s);r[p]=Yg(y,_,b,E,m)}return r}};function Yg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function fb(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function pb(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Yg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=fb(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ti=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Lo(e,this.TimeBufferType),this.values=Lo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Lo(t.times,Array),values:Lo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),gc(t.settings)&&(i.settings={inTangents:Lo(t.settings.inTangents,Array),outTangents:Lo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Wc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Hc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Vc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Xc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case za:e=this.InterpolantFactoryMethodDiscrete;break;case Ic:e=this.InterpolantFactoryMethodLinear;break;case vc:e=this.InterpolantFactoryMethodSmooth;break;case Md:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return za;case this.InterpolantFactoryMethodLinear:return Ic;case this.InterpolantFactoryMethodSmooth:return vc;case this.InterpolantFactoryMethodBezier:return Md}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;gc(this.settings)&&(eg(this.settings.inTangents,t),eg(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;gc(this.settings)&&(ng(this.settings.inTangents,t),ng(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ee("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ee("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ee("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ee("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&RS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ee("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===vc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let d=a*i,u=d-i,f=d+i;for(let p=0;p!==i;++p){let _=e[d+p];if(_!==e[u+p]||_!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let d=a*i,u=o*i;for(let f=0;f!==i;++f)e[u+f]=e[d+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,gc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function eg(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function ng(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Ti.prototype.ValueTypeName="";Ti.prototype.TimeBufferType=Float32Array;Ti.prototype.ValueBufferType=Float32Array;Ti.prototype.DefaultInterpolation=Ic;var mr=class extends Ti{constructor(t,e,i){super(t,e,i)}};mr.prototype.ValueTypeName="bool";mr.prototype.ValueBufferType=Array;mr.prototype.DefaultInterpolation=za;mr.prototype.InterpolantFactoryMethodLinear=void 0;mr.prototype.InterpolantFactoryMethodSmooth=void 0;var $c=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}};$c.prototype.ValueTypeName="color";var Yc=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}};Yc.prototype.ValueTypeName="number";var qc=class extends pr{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Ie.slerpFlat(r,0,o,c-a,o,c,l);return r}},nl=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new qc(this.times,this.values,this.getValueSize(),t)}};nl.prototype.ValueTypeName="quaternion";nl.prototype.InterpolantFactoryMethodSmooth=void 0;var gr=class extends Ti{constructor(t,e,i){super(t,e,i)}};gr.prototype.ValueTypeName="string";gr.prototype.ValueBufferType=Array;gr.prototype.DefaultInterpolation=za;gr.prototype.InterpolantFactoryMethodLinear=void 0;gr.prototype.InterpolantFactoryMethodSmooth=void 0;var Zc=class extends Ti{constructor(t,e,i,s){super(t,e,i,s)}};Zc.prototype.ValueTypeName="vector";var jc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,u=c.length;d<u;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},qg=new jc,Jc=class{constructor(t){this.manager=t!==void 0?t:qg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jc.DEFAULT_MATERIAL_NAME="__DEFAULT";var il=class extends un{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Zt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},sl=class extends il{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(un.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Zt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},bd=new Kt,ig=new R,sg=new R,Kc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new $t(512,512),this.mapType=di,this.map=null,this.mapPass=null,this.matrix=new Kt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new dr,this._frameExtents=new $t(1,1),this._viewportCount=1,this._viewports=[new Le(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;ig.setFromMatrixPosition(t.matrixWorld),e.position.copy(ig),sg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(sg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){bd.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(bd,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===zo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(bd)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},_c=new R,xc=new Ie,ds=new R,rl=class extends un{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Kt,this.projectionMatrix=new Kt,this.projectionMatrixInverse=new Kt,this.coordinateSystem=Ni,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(_c,xc,ds),ds.x===1&&ds.y===1&&ds.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_c,xc,ds.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(_c,xc,ds),ds.x===1&&ds.y===1&&ds.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_c,xc,ds.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hr=new R,rg=new $t,og=new $t,bi=class extends rl{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Vo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Fo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Vo*2*Math.atan(Math.tan(Fo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){hr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(hr.x,hr.y).multiplyScalar(-t/hr.z),hr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(hr.x,hr.y).multiplyScalar(-t/hr.z)}getViewSize(t,e){return this.getViewBounds(t,rg,og),e.subVectors(og,rg)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Fo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Xr=class extends rl{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Cd=class extends Kc{constructor(){super(new Xr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Yo=class extends il{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(un.DEFAULT_UP),this.updateMatrix(),this.target=new un,this.shadow=new Cd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var ol=class extends Me{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Do=-90,No=1,qo=class extends un{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new bi(Do,No,t,e);s.layers=this.layers,this.add(s);let r=new bi(Do,No,t,e);r.layers=this.layers,this.add(r);let o=new bi(Do,No,t,e);o.layers=this.layers,this.add(o);let a=new bi(Do,No,t,e);a.layers=this.layers,this.add(a);let l=new bi(Do,No,t,e);l.layers=this.layers,this.add(l);let c=new bi(Do,No,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Ni)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===zo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Qc=class extends bi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var hf="\\[\\]\\.:\\/",mb=new RegExp("["+hf+"]","g"),uf="[^"+hf+"]",gb="[^"+hf.replace("\\.","")+"]",_b=/((?:WC+[\/:])*)/.source.replace("WC",uf),xb=/(WCOD+)?/.source.replace("WCOD",gb),yb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",uf),vb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",uf),Sb=new RegExp("^"+_b+xb+yb+vb+"$"),bb=["material","materials","bones","map"],Rd=class{constructor(t,e,i){let s=i||Qe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Qe=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(mb,"")}static parseTrackName(t){let e=Sb.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);bb.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ee("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ee("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ee("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ee("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ee("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ee("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Qe.Composite=Rd;Qe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Qe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Qe.prototype.GetterByBindingType=[Qe.prototype._getValue_direct,Qe.prototype._getValue_array,Qe.prototype._getValue_arrayElement,Qe.prototype._getValue_toArray];Qe.prototype.SetterByBindingTypeAndVersioning=[[Qe.prototype._setValue_direct,Qe.prototype._setValue_direct_setNeedsUpdate,Qe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Qe.prototype._setValue_array,Qe.prototype._setValue_array_setNeedsUpdate,Qe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Qe.prototype._setValue_arrayElement,Qe.prototype._setValue_arrayElement_setNeedsUpdate,Qe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Qe.prototype._setValue_fromArray,Qe.prototype._setValue_fromArray_setNeedsUpdate,Qe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var W2=new Float32Array(1);var _r=class extends qa{constructor(t,e,i=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var ag=new Kt,$r=class{constructor(t,e,i=0,s=1/0){this.ray=new ur(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Wo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ee("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return ag.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(ag),this}intersectObject(t,e=!0,i=[]){return Pd(t,this,i,e),i.sort(lg),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Pd(t[s],this,i,e);return i.sort(lg),i}};function lg(n,t){return n.distance-t.distance}function Pd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Pd(r[o],t,e,!0)}}var Zo=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var _f=class _f{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};_f.prototype.isMatrix2=!0;var Id=_f;var cg=new R,yc=new R,Oo=new R,Uo=new R,wd=new R,wb=new R,Mb=new R,al=class{constructor(t=new R,e=new R){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){cg.subVectors(t,this.start),yc.subVectors(this.end,this.start);let i=yc.dot(yc);if(i===0)return 0;let r=yc.dot(cg)/i;return e&&(r=ce(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=wb,i=Mb){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,h=t.end;Oo.subVectors(c,a),Uo.subVectors(h,l),wd.subVectors(a,l);let d=Oo.dot(Oo),u=Uo.dot(Uo),f=Uo.dot(wd);if(d<=s&&u<=s)return e.copy(a),i.copy(l),e.distanceToSquared(i);if(d<=s)r=0,o=f/u,o=ce(o,0,1);else{let p=Oo.dot(wd);if(u<=s)o=0,r=ce(-p/d,0,1);else{let _=Oo.dot(Uo),m=d*u-_*_;m!==0?r=ce((_*f-p*u)/m,0,1):r=0,o=(_*r+f)/u,o<0?(o=0,r=ce(-p/d,0,1)):o>1&&(o=1,r=ce((_-p)/d,0,1))}}return e.copy(a).addScaledVector(Oo,r),i.copy(l).addScaledVector(Uo,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var ll=class extends Gs{constructor(t=10,e=10,i=4473924,s=8947848){i=new Zt(i),s=new Zt(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let u=0,f=0,p=-a;u<=e;u++,p+=o){l.push(-a,0,p,a,0,p),l.push(p,0,-a,p,0,a);let _=u===r?i:s;_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3}let h=new Me;h.setAttribute("position",new ie(l,3)),h.setAttribute("color",new ie(c,3));let d=new Fi({vertexColors:!0,toneMapped:!1});super(h,d),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var Yr=class extends ji{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function df(n,t,e,i){let s=Eb(i);switch(e){case jd:return n*t;case lh:return n*t/s.components*s.byteLength;case ch:return n*t/s.components*s.byteLength;case Sr:return n*t*2/s.components*s.byteLength;case hh:return n*t*2/s.components*s.byteLength;case Jd:return n*t*3/s.components*s.byteLength;case Qi:return n*t*4/s.components*s.byteLength;case uh:return n*t*4/s.components*s.byteLength;case hl:case ul:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case dl:case fl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case fh:case mh:return Math.max(n,16)*Math.max(t,8)/4;case dh:case ph:return Math.max(n,8)*Math.max(t,8)/2;case gh:case _h:case yh:case vh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case xh:case pl:case Sh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case bh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case wh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Mh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Eh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Ah:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Th:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ch:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Rh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Ph:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Ih:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Lh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Dh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Nh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Oh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Uh:case Fh:case Bh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case kh:case zh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case ml:case Gh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Eb(n){switch(n){case di:case $d:return{byteLength:1,components:1};case Qo:case Yd:case Ki:return{byteLength:2,components:1};case oh:case ah:return{byteLength:2,components:4};case Ji:case rh:case zi:return{byteLength:4,components:1};case qd:case Zd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function g0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Pb(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,d=c.byteLength,u=n.createBuffer();n.bindBuffer(l,u),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,h);else{d.sort((f,p)=>f.start-p.start);let u=0;for(let f=1;f<d.length;f++){let p=d[u],_=d[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++u,d[u]=_)}d.length=u+1;for(let f=0,p=d.length;f<p;f++){let _=d[f];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ib=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Lb=`#ifdef USE_ALPHAHASH
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
#endif`,Db=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Nb=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ob=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Ub=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Fb=`#ifdef USE_AOMAP
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
#endif`,Bb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kb=`#ifdef USE_BATCHING
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
#endif`,zb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Gb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Vb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Hb=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Wb=`#ifdef USE_IRIDESCENCE
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
#endif`,Xb=`#ifdef USE_BUMPMAP
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
#endif`,$b=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Yb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,qb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Zb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,jb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Jb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Kb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Qb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,tw=`#define PI 3.141592653589793
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
} // validated`,ew=`vec3 transformedNormal = objectNormal;
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
#endif`,nw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,iw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ow="gl_FragColor = linearToOutputTexel( gl_FragColor );",aw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lw=`#ifdef USE_ENVMAP
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
#endif`,cw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,hw=`#ifdef USE_ENVMAP
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
#endif`,uw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,dw=`#ifdef USE_ENVMAP
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
#endif`,fw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,_w=`#ifdef USE_GRADIENTMAP
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
}`,xw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,yw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,vw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Sw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,bw=`#ifdef USE_ENVMAP
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
#endif`,ww=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Mw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Ew=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Aw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Tw=`PhysicalMaterial material;
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
#endif`,Cw=`uniform sampler2D dfgLUT;
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
}`,Rw=`
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
#endif`,Pw=`#if defined( RE_IndirectDiffuse )
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
#endif`,Iw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Lw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Dw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Nw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ow=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Uw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Fw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Bw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,zw=`#if defined( USE_POINTS_UV )
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
#endif`,Gw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Vw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Hw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ww=`#if defined( USE_MORPHCOLORS )
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
#endif`,Xw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$w=`#ifdef USE_MORPHTARGETS
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
#endif`,Yw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qw=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Zw=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,jw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Jw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Kw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Qw=`#ifdef USE_NORMALMAP
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
#endif`,tM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,eM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,nM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,rM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,oM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,aM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,lM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,cM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,dM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,pM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,mM=`float getShadowMask() {
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
}`,gM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,_M=`#ifdef USE_SKINNING
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
#endif`,xM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,yM=`#ifdef USE_SKINNING
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
#endif`,vM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,SM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,bM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,wM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,MM=`#ifdef USE_TRANSMISSION
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
#endif`,EM=`#ifdef USE_TRANSMISSION
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
#endif`,AM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,TM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,RM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,PM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,IM=`uniform sampler2D t2D;
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
}`,LM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,DM=`uniform float backgroundBlurriness;
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
}`,NM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UM=`#include <common>
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
}`,FM=`#if DEPTH_PACKING == 3200
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
}`,BM=`#define DISTANCE
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
}`,kM=`#define DISTANCE
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
}`,zM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VM=`uniform float scale;
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
}`,HM=`uniform vec3 diffuse;
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
}`,WM=`#include <common>
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
}`,XM=`uniform vec3 diffuse;
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
}`,$M=`#define LAMBERT
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
}`,YM=`#define LAMBERT
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
}`,qM=`#define MATCAP
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
}`,ZM=`#define MATCAP
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
}`,jM=`#define NORMAL
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
}`,JM=`#define NORMAL
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
}`,KM=`#define PHONG
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
}`,QM=`#define PHONG
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
}`,t1=`#define STANDARD
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
}`,e1=`#define STANDARD
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
}`,n1=`#define TOON
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
}`,i1=`#define TOON
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
}`,s1=`uniform float size;
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
}`,r1=`uniform vec3 diffuse;
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
}`,o1=`#include <common>
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
}`,a1=`uniform vec3 color;
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
}`,l1=`uniform float rotation;
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
}`,c1=`uniform vec3 diffuse;
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
}`,fe={alphahash_fragment:Ib,alphahash_pars_fragment:Lb,alphamap_fragment:Db,alphamap_pars_fragment:Nb,alphatest_fragment:Ob,alphatest_pars_fragment:Ub,aomap_fragment:Fb,aomap_pars_fragment:Bb,batching_pars_vertex:kb,batching_vertex:zb,begin_vertex:Gb,beginnormal_vertex:Vb,bsdfs:Hb,iridescence_fragment:Wb,bumpmap_pars_fragment:Xb,clipping_planes_fragment:$b,clipping_planes_pars_fragment:Yb,clipping_planes_pars_vertex:qb,clipping_planes_vertex:Zb,color_fragment:jb,color_pars_fragment:Jb,color_pars_vertex:Kb,color_vertex:Qb,common:tw,defaultnormal_vertex:ew,displacementmap_pars_vertex:nw,displacementmap_vertex:iw,emissivemap_fragment:sw,emissivemap_pars_fragment:rw,colorspace_fragment:ow,colorspace_pars_fragment:aw,envmap_fragment:lw,envmap_common_pars_fragment:cw,envmap_pars_fragment:hw,envmap_pars_vertex:uw,envmap_physical_pars_fragment:bw,envmap_vertex:dw,fog_vertex:fw,fog_pars_vertex:pw,fog_fragment:mw,fog_pars_fragment:gw,gradientmap_pars_fragment:_w,lightmap_pars_fragment:xw,lights_lambert_fragment:yw,lights_lambert_pars_fragment:vw,lights_pars_begin:Sw,lights_toon_fragment:ww,lights_toon_pars_fragment:Mw,lights_phong_fragment:Ew,lights_phong_pars_fragment:Aw,lights_physical_fragment:Tw,lights_physical_pars_fragment:Cw,lights_fragment_begin:Rw,lights_fragment_maps:Pw,lights_fragment_end:Iw,lightprobes_pars_fragment:Lw,logdepthbuf_fragment:Dw,logdepthbuf_pars_fragment:Nw,logdepthbuf_pars_vertex:Ow,logdepthbuf_vertex:Uw,map_fragment:Fw,map_pars_fragment:Bw,map_particle_fragment:kw,map_particle_pars_fragment:zw,metalnessmap_fragment:Gw,metalnessmap_pars_fragment:Vw,morphinstance_vertex:Hw,morphcolor_vertex:Ww,morphnormal_vertex:Xw,morphtarget_pars_vertex:$w,morphtarget_vertex:Yw,normal_fragment_begin:qw,normal_fragment_maps:Zw,normal_pars_fragment:jw,normal_pars_vertex:Jw,normal_vertex:Kw,normalmap_pars_fragment:Qw,clearcoat_normal_fragment_begin:tM,clearcoat_normal_fragment_maps:eM,clearcoat_pars_fragment:nM,iridescence_pars_fragment:iM,opaque_fragment:sM,packing:rM,premultiplied_alpha_fragment:oM,project_vertex:aM,dithering_fragment:lM,dithering_pars_fragment:cM,roughnessmap_fragment:hM,roughnessmap_pars_fragment:uM,shadowmap_pars_fragment:dM,shadowmap_pars_vertex:fM,shadowmap_vertex:pM,shadowmask_pars_fragment:mM,skinbase_vertex:gM,skinning_pars_vertex:_M,skinning_vertex:xM,skinnormal_vertex:yM,specularmap_fragment:vM,specularmap_pars_fragment:SM,tonemapping_fragment:bM,tonemapping_pars_fragment:wM,transmission_fragment:MM,transmission_pars_fragment:EM,uv_pars_fragment:AM,uv_pars_vertex:TM,uv_vertex:CM,worldpos_vertex:RM,background_vert:PM,background_frag:IM,backgroundCube_vert:LM,backgroundCube_frag:DM,cube_vert:NM,cube_frag:OM,depth_vert:UM,depth_frag:FM,distance_vert:BM,distance_frag:kM,equirect_vert:zM,equirect_frag:GM,linedashed_vert:VM,linedashed_frag:HM,meshbasic_vert:WM,meshbasic_frag:XM,meshlambert_vert:$M,meshlambert_frag:YM,meshmatcap_vert:qM,meshmatcap_frag:ZM,meshnormal_vert:jM,meshnormal_frag:JM,meshphong_vert:KM,meshphong_frag:QM,meshphysical_vert:t1,meshphysical_frag:e1,meshtoon_vert:n1,meshtoon_frag:i1,points_vert:s1,points_frag:r1,shadow_vert:o1,shadow_frag:a1,sprite_vert:l1,sprite_frag:c1},It={common:{diffuse:{value:new Zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new $t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new Zt(16777215)},opacity:{value:1},center:{value:new $t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},li={basic:{uniforms:Kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:Kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new Zt(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:Kn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new Zt(0)},specular:{value:new Zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:Kn([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new Zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:Kn([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new Zt(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:Kn([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:Kn([It.points,It.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:Kn([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:Kn([It.common,It.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:Kn([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:Kn([It.sprite,It.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:Kn([It.common,It.displacementmap,{referencePosition:{value:new R},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:Kn([It.lights,It.fog,{color:{value:new Zt(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};li.physical={uniforms:Kn([li.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new $t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new Zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new $t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new Zt(0)},specularColor:{value:new Zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new $t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var Hh={r:0,b:0,g:0},h1=new Kt,_0=new se;_0.set(-1,0,0,0,1,0,0,0,1);function u1(n,t,e,i,s,r){let o=new Zt(0),a=s===!0?0:1,l,c,h=null,d=0,u=null;function f(x){let b=x.isScene===!0?x.background:null;if(b&&b.isTexture){let v=x.backgroundBlurriness>0;b=t.get(b,v)}return b}function p(x){let b=!1,v=f(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),b=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,b){let v=f(b);v&&v.isCubeTexture?(c===void 0&&(c=new mt(new Ye(1,1,1),new ki({name:"BackgroundCubeMaterial",uniforms:Kr(li.backgroundCube.uniforms),vertexShader:li.backgroundCube.vertexShader,fragmentShader:li.backgroundCube.fragmentShader,side:ai,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(h1.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(_0),c.material.toneMapped=ve.getTransfer(v.colorSpace)!==Pe,(h!==v||d!==v.version||u!==n.toneMapping)&&(c.material.needsUpdate=!0,h=v,d=v.version,u=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new mt(new Hr(2,2),new ki({name:"BackgroundMaterial",uniforms:Kr(li.background.uniforms),vertexShader:li.background.vertexShader,fragmentShader:li.background.fragmentShader,side:vr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=ve.getTransfer(v.colorSpace)!==Pe,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||d!==v.version||u!==n.toneMapping)&&(l.material.needsUpdate=!0,h=v,d=v.version,u=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,b){x.getRGB(Hh,cf(n)),e.buffers.color.setClear(Hh.r,Hh.g,Hh.b,b,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,b=1){o.set(x),a=b,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function d1(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=u(null),r=s,o=!1;function a(D,F,z,O,G){let q=!1,V=d(D,O,z,F);r!==V&&(r=V,c(r.object)),q=f(D,O,z,G),q&&p(D,O,z,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,v(D,F,z,O),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function h(D){return n.deleteVertexArray(D)}function d(D,F,z,O){let G=O.wireframe===!0,q=i[F.id];q===void 0&&(q={},i[F.id]=q);let V=D.isInstancedMesh===!0?D.id:0,ot=q[V];ot===void 0&&(ot={},q[V]=ot);let $=ot[z.id];$===void 0&&($={},ot[z.id]=$);let K=$[G];return K===void 0&&(K=u(l()),$[G]=K),K}function u(D){let F=[],z=[],O=[];for(let G=0;G<e;G++)F[G]=0,z[G]=0,O[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:z,attributeDivisors:O,object:D,attributes:{},index:null}}function f(D,F,z,O){let G=r.attributes,q=F.attributes,V=0,ot=z.getAttributes();for(let $ in ot)if(ot[$].location>=0){let et=G[$],ht=q[$];if(ht===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(ht=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(ht=D.instanceColor)),et===void 0||et.attribute!==ht||ht&&et.data!==ht.data)return!0;V++}return r.attributesNum!==V||r.index!==O}function p(D,F,z,O){let G={},q=F.attributes,V=0,ot=z.getAttributes();for(let $ in ot)if(ot[$].location>=0){let et=q[$];et===void 0&&($==="instanceMatrix"&&D.instanceMatrix&&(et=D.instanceMatrix),$==="instanceColor"&&D.instanceColor&&(et=D.instanceColor));let ht={};ht.attribute=et,et&&et.data&&(ht.data=et.data),G[$]=ht,V++}r.attributes=G,r.attributesNum=V,r.index=O}function _(){let D=r.newAttributes;for(let F=0,z=D.length;F<z;F++)D[F]=0}function m(D){g(D,0)}function g(D,F){let z=r.newAttributes,O=r.enabledAttributes,G=r.attributeDivisors;z[D]=1,O[D]===0&&(n.enableVertexAttribArray(D),O[D]=1),G[D]!==F&&(n.vertexAttribDivisor(D,F),G[D]=F)}function x(){let D=r.newAttributes,F=r.enabledAttributes;for(let z=0,O=F.length;z<O;z++)F[z]!==D[z]&&(n.disableVertexAttribArray(z),F[z]=0)}function b(D,F,z,O,G,q,V){V===!0?n.vertexAttribIPointer(D,F,z,G,q):n.vertexAttribPointer(D,F,z,O,G,q)}function v(D,F,z,O){_();let G=O.attributes,q=z.getAttributes(),V=F.defaultAttributeValues;for(let ot in q){let $=q[ot];if($.location>=0){let K=G[ot];if(K===void 0&&(ot==="instanceMatrix"&&D.instanceMatrix&&(K=D.instanceMatrix),ot==="instanceColor"&&D.instanceColor&&(K=D.instanceColor)),K!==void 0){let et=K.normalized,ht=K.itemSize,ut=t.get(K);if(ut===void 0)continue;let Q=ut.buffer,gt=ut.type,yt=ut.bytesPerElement,Ct=gt===n.INT||gt===n.UNSIGNED_INT||K.gpuType===rh;if(K.isInterleavedBufferAttribute){let wt=K.data,Wt=wt.isInterleavedBuffer===!0?wt.stride:wt.itemSize,ae=K.offset;if(wt.isInstancedInterleavedBuffer||wt.isInstancedBufferAttribute){for(let Vt=0;Vt<$.locationSize;Vt++)g($.location+Vt,wt.meshPerAttribute);D.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=wt.meshPerAttribute*wt.count)}else for(let Vt=0;Vt<$.locationSize;Vt++)m($.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Vt=0;Vt<$.locationSize;Vt++)b($.location+Vt,ht/$.locationSize,gt,et,Wt*yt,(ae+ht/$.locationSize*Vt)*yt,Ct)}else{if(K.isInstancedBufferAttribute){for(let wt=0;wt<$.locationSize;wt++)g($.location+wt,K.meshPerAttribute);D.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let wt=0;wt<$.locationSize;wt++)m($.location+wt);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let wt=0;wt<$.locationSize;wt++)b($.location+wt,ht/$.locationSize,gt,et,ht*yt,ht/$.locationSize*wt*yt,Ct)}}else if(V!==void 0){let et=V[ot];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv($.location,et);break;case 3:n.vertexAttrib3fv($.location,et);break;case 4:n.vertexAttrib4fv($.location,et);break;default:n.vertexAttrib1fv($.location,et)}}}}x()}function C(){I();for(let D in i){let F=i[D];for(let z in F){let O=F[z];for(let G in O){let q=O[G];for(let V in q)h(q[V].object),delete q[V];delete O[G]}}delete i[D]}}function E(D){if(i[D.id]===void 0)return;let F=i[D.id];for(let z in F){let O=F[z];for(let G in O){let q=O[G];for(let V in q)h(q[V].object),delete q[V];delete O[G]}}delete i[D.id]}function y(D){for(let F in i){let z=i[F];for(let O in z){let G=z[O];if(G[D.id]===void 0)continue;let q=G[D.id];for(let V in q)h(q[V].object),delete q[V];delete G[D.id]}}}function w(D){for(let F in i){let z=i[F],O=D.isInstancedMesh===!0?D.id:0,G=z[O];if(G!==void 0){for(let q in G){let V=G[q];for(let ot in V)h(V[ot].object),delete V[ot];delete G[q]}delete z[O],Object.keys(z).length===0&&delete i[F]}}}function I(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:P,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function f1(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];e.update(u,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function p1(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Qi&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===Ki&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==di&&y!==zi&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(qt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:b,maxFragmentUniforms:v,maxSamples:C,samples:E}}function m1(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Si,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){let f=d.length!==0||u||i!==0||s;return s=u,i=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){let p=d.clippingPlanes,_=d.clipIntersection,m=d.clipShadows,g=n.get(d);if(!s||p===null||p.length===0||r&&!m)r?h(null):c();else{let x=r?0:i,b=x*4,v=g.clippingState||null;l.value=v,v=h(p,u,b,f);for(let C=0;C!==b;++C)v[C]=e[C];g.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(d,u,f,p){let _=d!==null?d.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,x=u.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let b=0,v=f;b!==_;++b,v+=4)o.copy(d[b]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var vl=class extends wi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new ja(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ye(5,5,5),r=new ki({name:"CubemapFromEquirect",uniforms:Kr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ai,blending:qr});r.uniforms.tEquirect.value=e;let o=new mt(s,r),a=e.minFilter;return e.minFilter===Ws&&(e.minFilter=ri),new qo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Zg=256,g1=3,_1=20,x0=256,y0=16,x1=3,y1=new R,v1=new Zt,Xh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qo(1,10,null),this._boxMesh=new mt(new Ye(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=y1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(v1));let m=new qo(i,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=p,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Kg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Jg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Zg,of(t))}_fromTexture(t,e){t.mapping===jr||t.mapping===Ko?this._setSize(t.image.length===0?Zg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=jg(t,!1,!1),i=Math.log2(t)-g1;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=jg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===jr||t.mapping===Ko?(this._cubemapMaterial===null&&(this._cubemapMaterial=Kg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Jg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=S1(),this._integrationMaterial=b1());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/y0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-x1)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(x0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=w1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function jg(n,t,e){return new vl(n,{minFilter:Ws,generateMipmaps:t,type:Ki,colorSpace:Ga,depthBuffer:e})}function Sl(n,t,e){return new ki({name:n,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:ai,blending:qr,depthTest:!1,depthWrite:!1})}function S1(){return Sl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${x0}u

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
	`)}function b1(){return Sl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:y0}},`

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
	`)}function w1(){return Sl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${_1}
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
	`)}function Jg(){return Sl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Kg(){return Sl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function M1(n){let t=new WeakMap,e=new WeakMap,i=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){let f=u.mapping;if(f===nh||f===ih)if(t.has(u)){let p=t.get(u).texture;return a(p,u.mapping)}else{let p=u.image;if(p&&p.height>0){let _=new vl(p.height);return _.fromEquirectangularTexture(n,u),t.set(u,_),u.addEventListener("dispose",c),a(_.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){let f=u.mapping,p=f===nh||f===ih,_=f===jr||f===Ko;if(p||_){let m=e.get(u),g=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==g)return i===null&&(i=new Xh(n)),m=p?i.fromEquirectangular(u,m):i.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{let x=u.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new Xh(n)),m=p?i.fromEquirectangular(u):i.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,f){return f===nh?u.mapping=jr:f===ih&&(u.mapping=Ko),u}function l(u){let f=0,p=6;for(let _=0;_<p;_++)u[_]!==void 0&&f++;return f===p}function c(u){let f=u.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(u){let f=u.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function d(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function E1(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Ba("WebGLRenderer: "+i+" extension not supported."),s}}}function A1(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(p){let _=p.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function d(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,b=m.count>=65535?Ya:$a,v=new b(Math.ceil(x/3)*6,1),C=v.array;if(_!==null){let y=_.array;g=_.version;for(let w=0,I=0;w<x;w+=3){let P=y[w+0],D=y[w+1],F=y[w+2];C[I++]=P,C[I++]=D,C[I++]=D,C[I++]=F,C[I++]=F,C[I++]=P}}else{g=m.version;for(let y=0,w=0;y<x;y+=3){let I=y+0,P=y+1,D=y+2;C[w++]=I,C[w++]=P,C[w++]=P,C[w++]=D,C[w++]=D,C[w++]=I}}v.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,v)}function u(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function T1(n,t,e){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){n.drawElements(i,u,r,d*o),e.update(u,i,1)}function c(d,u,f){f!==0&&(n.drawElementsInstanced(i,u,r,d*o,f),e.update(u,i,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,u,0,r,d,0,f);let _=0;for(let m=0;m<f;m++)_+=u[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function C1(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ee("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function R1(n,t,e){let i=new WeakMap,s=new Le;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,u=i.get(a);if(u===void 0||u.count!==d){let I=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",I)};u!==void 0&&u.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],b=0;f===!0&&(b=1),p===!0&&(b=2),_===!0&&(b=3);let v=a.attributes.position.count*b,C=1;v>t.maxTextureSize&&(C=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let E=new Float32Array(v*C*4*d),y=new Xa(E,v,C,d);y.type=zi,y.needsUpdate=!0;let w=b*4;for(let P=0;P<d;P++){let D=m[P],F=g[P],z=x[P],O=v*C*4*P;for(let G=0;G<D.count;G++){let q=G*w;f===!0&&(s.fromBufferAttribute(D,G),E[O+q+0]=s.x,E[O+q+1]=s.y,E[O+q+2]=s.z,E[O+q+3]=0),p===!0&&(s.fromBufferAttribute(F,G),E[O+q+4]=s.x,E[O+q+5]=s.y,E[O+q+6]=s.z,E[O+q+7]=0),_===!0&&(s.fromBufferAttribute(z,G),E[O+q+8]=s.x,E[O+q+9]=s.y,E[O+q+10]=s.z,E[O+q+11]=z.itemSize===4?s.w:1)}}u={count:d,texture:y,size:new $t(v,C)},i.set(a,u),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",u.size)}return{update:r}}function P1(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var I1={[Bd]:"LINEAR_TONE_MAPPING",[kd]:"REINHARD_TONE_MAPPING",[zd]:"CINEON_TONE_MAPPING",[Gd]:"ACES_FILMIC_TONE_MAPPING",[Hd]:"AGX_TONE_MAPPING",[Wd]:"NEUTRAL_TONE_MAPPING",[Vd]:"CUSTOM_TONE_MAPPING"};function L1(n,t,e,i,s,r){let o=new wi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Me;h.setAttribute("position",new ie([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ie([0,2,0,0,2,0],2));let d=new kc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),u=new mt(h,d),f=new Xr(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,b=[],v=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let y=0;y<b.length;y++){let w=b[y];w.setSize&&w.setSize(C,E)}},this.setEffects=function(C){b=C,v=b.length>0&&b[0].isRenderPass===!0;let E=o.width,y=o.height;b.length>0&&a===null&&(a=new wi(E,y,{type:Ki,depthBuffer:!1,stencilBuffer:!1}),l=new wi(E,y,{type:Ki,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&b.some(I=>I.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new Vs(E,y),r===!0&&(c.format=Xs,c.type=Jr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let I=0;I<b.length;I++){let P=b[I];P.setSize&&P.setSize(E,y),w&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===ms&&b.length===0)return!1;if(x=E,E!==null){let y=E.width,w=E.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return v===!1&&C.setRenderTarget(o),g=C.toneMapping,C.toneMapping=ms,!0},this.hasRenderPass=function(){return v},this.end=function(C,E){C.toneMapping=g,m=!0;let y=o,w=a;for(let I=0;I<b.length;I++){let P=b[I];P.enabled!==!1&&(P.render(C,w,y,E),P.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(p!==C.outputColorSpace||_!==C.toneMapping){p=C.outputColorSpace,_=C.toneMapping,d.defines={},ve.getTransfer(p)===Pe&&(d.defines.SRGB_TRANSFER="");let I=I1[_];I&&(d.defines[I]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(x),C.render(u,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var v0=new hi,S0=new Vs(1,1),b0=new Ja(1),w0=new Xa,M0=new Nc,E0=new ja,Qg=[],t0=[],e0=new Float32Array(16),n0=new Float32Array(9),i0=new Float32Array(4);function ia(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Qg[s];if(r===void 0&&(r=new Float32Array(s),Qg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Pn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function In(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function $h(n,t){let e=t0[t];e===void 0&&(e=new Int32Array(t),t0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function D1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function N1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pn(e,t))return;n.uniform2fv(this.addr,t),In(e,t)}}function O1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Pn(e,t))return;n.uniform3fv(this.addr,t),In(e,t)}}function U1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pn(e,t))return;n.uniform4fv(this.addr,t),In(e,t)}}function F1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),In(e,t)}else{if(Pn(e,i))return;i0.set(i),n.uniformMatrix2fv(this.addr,!1,i0),In(e,i)}}function B1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),In(e,t)}else{if(Pn(e,i))return;n0.set(i),n.uniformMatrix3fv(this.addr,!1,n0),In(e,i)}}function k1(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),In(e,t)}else{if(Pn(e,i))return;e0.set(i),n.uniformMatrix4fv(this.addr,!1,e0),In(e,i)}}function z1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function G1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pn(e,t))return;n.uniform2iv(this.addr,t),In(e,t)}}function V1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Pn(e,t))return;n.uniform3iv(this.addr,t),In(e,t)}}function H1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pn(e,t))return;n.uniform4iv(this.addr,t),In(e,t)}}function W1(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function X1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pn(e,t))return;n.uniform2uiv(this.addr,t),In(e,t)}}function $1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Pn(e,t))return;n.uniform3uiv(this.addr,t),In(e,t)}}function Y1(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pn(e,t))return;n.uniform4uiv(this.addr,t),In(e,t)}}function Yh(n){return n.version===0&&(n.compareFunction=tf,n.needsUpdate=!0),n}function q1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Yh(S0):r=v0,e.setTexture2D(t||r,s)}function Z1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||M0,s)}function j1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Yh(b0):r=E0,e.setTextureCube(t||r,s)}function J1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||w0,s)}function K1(n){switch(n){case 5126:return D1;case 35664:return N1;case 35665:return O1;case 35666:return U1;case 35674:return F1;case 35675:return B1;case 35676:return k1;case 5124:case 35670:return z1;case 35667:case 35671:return G1;case 35668:case 35672:return V1;case 35669:case 35673:return H1;case 5125:return W1;case 36294:return X1;case 36295:return $1;case 36296:return Y1;case 35678:case 36198:case 36298:case 36306:case 35682:return q1;case 35679:case 36299:case 36307:return Z1;case 35680:case 36300:case 36308:case 36293:return j1;case 36289:case 36303:case 36311:case 36292:return J1}}function Q1(n,t){n.uniform1fv(this.addr,t)}function tE(n,t){let e=ia(t,this.size,2);n.uniform2fv(this.addr,e)}function eE(n,t){let e=ia(t,this.size,3);n.uniform3fv(this.addr,e)}function nE(n,t){let e=ia(t,this.size,4);n.uniform4fv(this.addr,e)}function iE(n,t){let e=ia(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function sE(n,t){let e=ia(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function rE(n,t){let e=ia(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function oE(n,t){n.uniform1iv(this.addr,t)}function aE(n,t){n.uniform2iv(this.addr,t)}function lE(n,t){n.uniform3iv(this.addr,t)}function cE(n,t){n.uniform4iv(this.addr,t)}function hE(n,t){n.uniform1uiv(this.addr,t)}function uE(n,t){n.uniform2uiv(this.addr,t)}function dE(n,t){n.uniform3uiv(this.addr,t)}function fE(n,t){n.uniform4uiv(this.addr,t)}function pE(n,t,e){let i=this.cache,s=t.length,r=$h(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Yh(S0):o=v0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function mE(n,t,e){let i=this.cache,s=t.length,r=$h(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||M0,r[o])}function gE(n,t,e){let i=this.cache,s=t.length,r=$h(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Yh(b0):o=E0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function _E(n,t,e){let i=this.cache,s=t.length,r=$h(e,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||w0,r[o])}function xE(n){switch(n){case 5126:return Q1;case 35664:return tE;case 35665:return eE;case 35666:return nE;case 35674:return iE;case 35675:return sE;case 35676:return rE;case 5124:case 35670:return oE;case 35667:case 35671:return aE;case 35668:case 35672:return lE;case 35669:case 35673:return cE;case 5125:return hE;case 36294:return uE;case 36295:return dE;case 36296:return fE;case 35678:case 36198:case 36298:case 36306:case 35682:return pE;case 35679:case 36299:case 36307:return mE;case 35680:case 36300:case 36308:case 36293:return gE;case 36289:case 36303:case 36311:case 36292:return _E}}var vf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=K1(e.type)}},Sf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=xE(e.type)}},bf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},xf=/(\w+)(\])?(\[|\.)?/g;function s0(n,t){n.seq.push(t),n.map[t.id]=t}function yE(n,t,e){let i=n.name,s=i.length;for(xf.lastIndex=0;;){let r=xf.exec(i),o=xf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){s0(e,c===void 0?new vf(a,n,t):new Sf(a,n,t));break}else{let d=e.map[a];d===void 0&&(d=new bf(a),s0(e,d)),e=d}}}var ea=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);yE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function r0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var vE=37297,SE=0;function bE(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var o0=new se;function wE(n){ve._getMatrix(o0,ve.workingColorSpace,n);let t=`mat3( ${o0.elements.map(e=>e.toFixed(4))} )`;switch(ve.getTransfer(n)){case Va:return[t,"LinearTransferOETF"];case Pe:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function a0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+bE(n.getShaderSource(t),a)}else return r}function ME(n,t){let e=wE(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var EE={[Bd]:"Linear",[kd]:"Reinhard",[zd]:"Cineon",[Gd]:"ACESFilmic",[Hd]:"AgX",[Wd]:"Neutral",[Vd]:"Custom"};function AE(n,t){let e=EE[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Wh=new R;function TE(){ve.getLuminanceCoefficients(Wh);let n=Wh.x.toFixed(4),t=Wh.y.toFixed(4),e=Wh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function CE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(yl).join(`
`)}function RE(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function PE(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function yl(n){return n!==""}function l0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function c0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var IE=/^[ \t]*#include +<([\w\d./]+)>/gm;function wf(n){return n.replace(IE,LE)}function LE(n,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return wf(e)}var DE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function h0(n){return n.replace(DE,NE)}function NE(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function u0(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var OE={[Hs]:"SHADOWMAP_TYPE_PCF",[jo]:"SHADOWMAP_TYPE_VSM"};function UE(n){return OE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var FE={[Ko]:"ENVMAP_MODE_REFRACTION"};function BE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":FE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kE={[eh]:"ENVMAP_BLENDING_MULTIPLY",[Ig]:"ENVMAP_BLENDING_MIX",[Lg]:"ENVMAP_BLENDING_ADD"};function zE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kE[n.combine]||"ENVMAP_BLENDING_NONE"}function GE(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=UE(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=BE(e),d=zE(e),u=CE(e),f=RE(r),p=s.createProgram(),_,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(yl).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(yl).join(`
`),m.length>0&&(m+=`
`)):(_=[u0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(yl).join(`
`),m=[u0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ms?"#define TONE_MAPPING":"",e.toneMapping!==ms?fe.tonemapping_pars_fragment:"",e.toneMapping!==ms?AE("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,ME("linearToOutputTexel",e.outputColorSpace),TE(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(yl).join(`
`)),o=wf(o),o=l0(o,e),o=c0(o,e),a=wf(a),a=l0(a,e),a=c0(a,e),o=h0(o),a=h0(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===sf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===sf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,b=g+m+a,v=r0(s,s.VERTEX_SHADER,x),C=r0(s,s.FRAGMENT_SHADER,b);s.attachShader(p,v),s.attachShader(p,C),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(P){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(v)||"",z=s.getShaderInfoLog(C)||"",O=D.trim(),G=F.trim(),q=z.trim(),V=!0,ot=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,C);else{let $=a0(s,v,"vertex"),K=a0(s,C,"fragment");ee("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+O+`
`+$+`
`+K)}else O!==""?qt("WebGLProgram: Program Info Log:",O):(G===""||q==="")&&(ot=!1);ot&&(P.diagnostics={runnable:V,programLog:O,vertexShader:{log:G,prefix:_},fragmentShader:{log:q,prefix:m}})}s.deleteShader(v),s.deleteShader(C),y=new ea(s,p),w=PE(s,p)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,vE)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=SE++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=C,this}var VE=0,Mf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Ef(t),e.set(t,i)),i}},Ef=class{constructor(t){this.id=VE++,this.code=t,this.usedTimes=0}};function HE(n){return n===Sr||n===pl||n===ml}function WE(n,t,e,i,s,r){let o=new Wo,a=new Mf,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,w,I,P,D,F){let z=P.fog,O=D.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,V=t.get(y.envMap||G,q),ot=u[y.type],$=i.precision;y.precision!==null&&($=i.getMaxPrecision(y.precision),$!==y.precision&&qt("WebGLProgram.getParameters:",y.precision,"not supported, using",$,"instead."));let K=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,et=K!==void 0?K.length:0,ht=0;O.morphAttributes.position!==void 0&&(ht=1),O.morphAttributes.normal!==void 0&&(ht=2),O.morphAttributes.color!==void 0&&(ht=3);let ut,Q,gt,yt;if(ot){let Rt=li[ot];ut=Rt.vertexShader,Q=Rt.fragmentShader}else{ut=y.vertexShader,Q=y.fragmentShader;let Rt=a.getVertexShaderStage(y),he=a.getFragmentShaderStage(y);a.update(y,Rt,he),gt=Rt.id,yt=he.id}let Ct=n.getRenderTarget(),wt=n.state.buffers.depth.getReversed(),Wt=D.isInstancedMesh===!0,ae=D.isBatchedMesh===!0,Vt=!!y.map,me=!!y.matcap,ue=!!V,re=ue&&V.isPMREMTexture===!0,nn=!!y.aoMap,$e=!!y.lightMap,vn=!!y.bumpMap&&y.wireframe===!1,ke=!!y.normalMap,On=!!y.displacementMap,be=!!y.emissiveMap,Cn=!!y.metalnessMap,dn=!!y.roughnessMap,Sn=y.anisotropy>0,k=y.clearcoat>0,Pt=y.diffuseRoughness>0,jt=y.dispersion>0,le=y.retroreflectivity>0,Mt=y.iridescence>0,Ve=y.sheen>0,Gt=y.transmission>0,Yt=Sn&&!!y.anisotropyMap,L=k&&!!y.clearcoatMap,M=k&&!!y.clearcoatNormalMap,Y=k&&!!y.clearcoatRoughnessMap,dt=Pt&&!!y.diffuseRoughnessMap,at=Mt&&!!y.iridescenceMap,xt=Mt&&!!y.iridescenceThicknessMap,vt=Ve&&!!y.sheenColorMap,nt=Ve&&!!y.sheenRoughnessMap,st=!!y.specularMap,pt=!!y.specularColorMap,B=!!y.specularIntensityMap,rt=Gt&&!!y.transmissionMap,it=Gt&&!!y.thicknessMap,Et=!!y.gradientMap,_t=!!y.alphaMap,bt=y.alphaTest>0,Ht=!!y.alphaHash,Qt=!!y.extensions,ct=ms;y.toneMapped&&(Ct===null||Ct.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Bt=re?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,te={shaderID:ot,shaderType:y.type,shaderName:y.name,vertexShader:ut,fragmentShader:Q,defines:y.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:$,batching:ae,batchingColor:ae&&D._colorsTexture!==null,instancing:Wt,instancingColor:Wt&&D.instanceColor!==null,instancingMorph:Wt&&D.morphTexture!==null,outputColorSpace:Ct===null?n.outputColorSpace:Ct.isXRRenderTarget===!0?Ct.texture.colorSpace:ve.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:me,envMap:ue,envMapMode:ue&&V.mapping,envMapPMREM:re,envMapMaxLod:re?Bt.length-1:null,envMapSize:re?Bt[0].width:null,aoMap:nn,lightMap:$e,bumpMap:vn,normalMap:ke,displacementMap:On,emissiveMap:be,normalMapObjectSpace:ke&&y.normalMapType===Og,normalMapTangentSpace:ke&&y.normalMapType===gl,packedNormalMap:ke&&y.normalMapType===gl&&HE(y.normalMap.format),metalnessMap:Cn,roughnessMap:dn,anisotropy:Sn,anisotropyMap:Yt,clearcoat:k,clearcoatMap:L,clearcoatNormalMap:M,clearcoatRoughnessMap:Y,diffuseRoughness:Pt,diffuseRoughnessMap:dt,dispersion:jt,retroreflection:le,iridescence:Mt,iridescenceMap:at,iridescenceThicknessMap:xt,sheen:Ve,sheenColorMap:vt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:pt,specularIntensityMap:B,transmission:Gt,transmissionMap:rt,thicknessMap:it,gradientMap:Et,opaque:y.transparent===!1&&y.blending===Jo&&y.alphaToCoverage===!1,alphaMap:_t,alphaTest:bt,alphaHash:Ht,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:nn&&f(y.aoMap.channel),lightMapUv:$e&&f(y.lightMap.channel),bumpMapUv:vn&&f(y.bumpMap.channel),normalMapUv:ke&&f(y.normalMap.channel),displacementMapUv:On&&f(y.displacementMap.channel),emissiveMapUv:be&&f(y.emissiveMap.channel),metalnessMapUv:Cn&&f(y.metalnessMap.channel),roughnessMapUv:dn&&f(y.roughnessMap.channel),anisotropyMapUv:Yt&&f(y.anisotropyMap.channel),clearcoatMapUv:L&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:dt&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:pt&&f(y.specularColorMap.channel),specularIntensityMapUv:B&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:it&&f(y.thicknessMap.channel),alphaMapUv:_t&&f(y.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(ke||Sn),vertexNormals:!!O.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!O.attributes.uv&&(Vt||_t),fog:!!z,useFog:y.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||O.attributes.normal===void 0&&ke===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:wt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ht,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:F.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&ve.getTransfer(y.map.colorSpace)===Pe,decodeVideoTextureEmissive:be&&y.emissiveMap.isVideoTexture===!0&&ve.getTransfer(y.emissiveMap.colorSpace)===Pe,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===on,flipSided:y.side===ai,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Qt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&y.extensions.multiDraw===!0||ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function _(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)w.push(I),w.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(m(w,y),g(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function m(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let w=u[y.type],I;if(w){let P=li[w];I=_l.clone(P.uniforms)}else I=y.uniforms;return I}function b(y,w){let I=h.get(w);return I!==void 0?++I.usedTimes:(I=new GE(n,w,y,s),c.push(I),h.set(w,I)),I}function v(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:b,releaseProgram:v,releaseShaderCache:C,programs:c,dispose:E}}function XE(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function $E(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function d0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function f0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,p,_,m,g){let x=n[t];return x===void 0?(x={id:u.id,object:u,geometry:f,material:p,materialVariant:o(u),groupOrder:_,renderOrder:u.renderOrder,z:m,group:g},n[t]=x):(x.id=u.id,x.object=u,x.geometry=f,x.material=p,x.materialVariant=o(u),x.groupOrder=_,x.renderOrder=u.renderOrder,x.z=m,x.group=g),t++,x}function l(u,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let b=a(u,f,p,_,m,g);p.transmission>0?i.push(b):p.transparent===!0?s.push(b):e.push(b)}function c(u,f,p,_,m,g){let x=a(u,f,p,_,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function h(u,f){e.length>1&&e.sort(u||$E),i.length>1&&i.sort(f||d0),s.length>1&&s.sort(f||d0)}function d(){for(let u=t,f=n.length;u<f;u++){let p=n[u];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function YE(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new f0,n.set(i,[o])):s>=r.length?(o=new f0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function qE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new R,color:new Zt};break;case"SpotLight":e={position:new R,direction:new R,color:new Zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new R,color:new Zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new R,skyColor:new Zt,groundColor:new Zt};break;case"RectAreaLight":e={color:new Zt,position:new R,halfWidth:new R,halfHeight:new R};break}return n[t.id]=e,e}}}function ZE(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $t};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $t};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $t,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var jE=0;function JE(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function KE(n){let t=new qE,e=ZE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new R);let s=new R,r=new Kt,o=new Kt;function a(c){let h=0,d=0,u=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,b=0,v=0,C=0,E=0,y=0,w=0,I=0,P=0;c.sort(JE);for(let F=0,z=c.length;F<z;F++){let O=c[F],G=O.color,q=O.intensity,V=O.distance,ot=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===Sr?ot=O.shadow.map.texture:ot=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)h+=G.r*q,d+=G.g*q,u+=G.b*q;else if(O.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(O.sh.coefficients[$],q);P++}else if(O.isSunLight){let $=t.get(O);if($.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let K=O.shadow,et=e.get(O);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[p]=et,i.sunShadowMap[p]=ot;let ht=K.getViewportCount();for(let ut=0;ut<ht;ut++)i.sunShadowMatrix[_+ut]=K.getMatrix(ut),i.sunShadowCascade[_+ut]=K._cascadeData[ut];_+=ht,p++}i.sun[f]=$,f++}else if(O.isDirectionalLight){let $=t.get(O);if($.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let K=O.shadow,et=e.get(O);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize=K.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=ot,i.directionalShadowMatrix[m]=O.shadow.matrix,C++}i.directional[m]=$,m++}else if(O.isSpotLight){let $=t.get(O);$.position.setFromMatrixPosition(O.matrixWorld),$.color.copy(G).multiplyScalar(q),$.distance=V,$.coneCos=Math.cos(O.angle),$.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),$.decay=O.decay,i.spot[x]=$;let K=O.shadow;if(O.map&&(i.spotLightMap[w]=O.map,w++,K.updateMatrices(O),O.castShadow&&I++),i.spotLightMatrix[x]=K.matrix,O.castShadow){let et=e.get(O);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize=K.mapSize,i.spotShadow[x]=et,i.spotShadowMap[x]=ot,y++}x++}else if(O.isRectAreaLight){let $=t.get(O);$.color.copy(G).multiplyScalar(q),$.halfWidth.set(O.width*.5,0,0),$.halfHeight.set(0,O.height*.5,0),i.rectArea[b]=$,b++}else if(O.isPointLight){let $=t.get(O);if($.color.copy(O.color).multiplyScalar(O.intensity),$.distance=O.distance,$.decay=O.decay,O.castShadow){let K=O.shadow,et=e.get(O);et.shadowIntensity=K.intensity,et.shadowBias=K.bias,et.shadowNormalBias=K.normalBias,et.shadowRadius=K.radius,et.shadowMapSize=K.mapSize,et.shadowCameraNear=K.camera.near,et.shadowCameraFar=K.camera.far,i.pointShadow[g]=et,i.pointShadowMap[g]=ot,i.pointShadowMatrix[g]=O.shadow.matrix,E++}i.point[g]=$,g++}else if(O.isHemisphereLight){let $=t.get(O);$.skyColor.copy(O.color).multiplyScalar(q),$.groundColor.copy(O.groundColor).multiplyScalar(q),i.hemi[v]=$,v++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=It.LTC_FLOAT_1,i.rectAreaLTC2=It.LTC_FLOAT_2):(i.rectAreaLTC1=It.LTC_HALF_1,i.rectAreaLTC2=It.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=u;let D=i.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==g||D.spotLength!==x||D.rectAreaLength!==b||D.hemiLength!==v||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==y||D.numSpotMaps!==w||D.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=b,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-I,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=P,D.sunLength=f,D.directionalLength=m,D.pointLength=g,D.spotLength=x,D.rectAreaLength=b,D.hemiLength=v,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=y,D.numSpotMaps=w,D.numLightProbes=P,i.version=jE++)}function l(c,h){let d=0,u=0,f=0,p=0,_=0,m=0,g=h.matrixWorldInverse;for(let x=0,b=c.length;x<b;x++){let v=c[x];if(v.isSunLight){let C=i.sun[d];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(g),d++}else if(v.isDirectionalLight){let C=i.directional[u];C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),u++}else if(v.isSpotLight){let C=i.spot[p];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(g),C.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),C.halfWidth.set(v.width*.5,0,0),C.halfHeight.set(0,v.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let C=i.hemi[m];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function p0(n){let t=new KE(n),e=[],i=[],s=[];function r(d){h.camera=d,e.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){i.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QE(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new p0(n),t.set(s,[a])):r>=o.length?(a=new p0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var tA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eA=`uniform sampler2D shadow_pass;
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
}`,nA=[new R(1,0,0),new R(-1,0,0),new R(0,1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1)],iA=[new R(0,-1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1),new R(0,-1,0),new R(0,-1,0)],m0=new Kt,xl=new R,yf=new R;function sA(n,t,e){let i=new dr,s=new $t,r=new $t,o=new Le,a=new zc,l=new Gc,c={},h=e.maxTextureSize,d={[vr]:ai,[ai]:vr,[on]:on},u=new ki({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new $t},radius:{value:4}},vertexShader:tA,fragmentShader:eA}),f=u.clone();f.defines.HORIZONTAL_PASS=1;let p=new Me;p.setAttribute("position",new hn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new mt(p,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Hs;let g=this.type;this.render=function(E,y,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===dg&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Hs);let I=n.getRenderTarget(),P=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),F=n.state;F.setBlending(qr),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let z=g!==this.type;z&&y.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach(G=>G.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,G=E.length;O<G;O++){let q=E[O],V=q.shadow;if(V===void 0){qt("WebGLShadowMap:",q,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ot=V.getFrameExtents();s.multiply(ot),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/ot.x),s.x=r.x*ot.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/ot.y),s.y=r.y*ot.y,V.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=$,V.map===null||z===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===jo){if(q.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new wi(s.x,s.y,{format:Sr,type:Ki,minFilter:ri,magFilter:ri,generateMipmaps:!1}),V.map.texture.name=q.name+".shadowMap",V.map.depthTexture=new Vs(s.x,s.y,zi),V.map.depthTexture.name=q.name+".shadowMapDepth",V.map.depthTexture.format=ks,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Gn,V.map.depthTexture.magFilter=Gn}else q.isPointLight?(V.map=new vl(s.x),V.map.depthTexture=new Ja(s.x,Ji)):(V.map=new wi(s.x,s.y),V.map.depthTexture=new Vs(s.x,s.y,Ji)),V.map.depthTexture.name=q.name+".shadowMap",V.map.depthTexture.format=ks,this.type===Hs?(V.map.depthTexture.compareFunction=$?Qd:Kd,V.map.depthTexture.minFilter=ri,V.map.depthTexture.magFilter=ri):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=Gn,V.map.depthTexture.magFilter=Gn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let K=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();q.isPointLight!==!0&&V.updateMatrices(q,w);let et=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:w.layers;for(let ht=0;ht<K;ht++){let ut=V.getCamera(ht);if(q.isPointLight){let Q=V.camera,gt=V.matrix,yt=q.distance||Q.far;yt!==Q.far&&(Q.far=yt,Q.updateProjectionMatrix()),xl.setFromMatrixPosition(q.matrixWorld),Q.position.copy(xl),yf.copy(Q.position),yf.add(nA[ht]),Q.up.copy(iA[ht]),Q.lookAt(yf),Q.updateMatrixWorld(),gt.makeTranslation(-xl.x,-xl.y,-xl.z),m0.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),V._frustum.setFromProjectionMatrix(m0,Q.coordinateSystem,Q.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ht),n.clear();else{ht===0&&(n.setRenderTarget(V.map),n.clear());let Q=V.getViewport(ht);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),F.viewport(o)}i=V.getFrustum(ht),v(y,w,ut,q,et,this.type)}V.isPointLightShadow!==!0&&this.type===jo&&x(V,w),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(I,P,D)};function x(E,y){let w=t.update(_);u.defines.VSM_SAMPLES!==E.blurSamples&&(u.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new wi(s.x,s.y,{format:Sr,type:Ki}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),u.uniforms.shadow_pass.value=E.map.depthTexture,u.uniforms.resolution.value.set(E.map.width,E.map.height),u.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(y,null,w,u,_,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(y,null,w,f,_,null)}function b(E,y,w,I){let P=null,D=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)P=D;else if(P=w.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=P.uuid,z=y.uuid,O=c[F];O===void 0&&(O={},c[F]=O);let G=O[z];G===void 0&&(G=P.clone(),O[z]=G,y.addEventListener("dispose",C)),P=G}if(P.visible=y.visible,P.wireframe=y.wireframe,I===jo?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:d[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,w.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=n.properties.get(P);F.light=w}return P}function v(E,y,w,I,P,D){if(E.visible===!1)return;if(E.layers.test(P)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===jo)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let O=t.update(E),G=E.material;if(Array.isArray(G)){let q=O.groups;for(let V=0,ot=q.length;V<ot;V++){let $=q[V],K=G[$.materialIndex];if(K&&K.visible){let et=b(E,K,I,D);E.onBeforeShadow(n,E,y,w,O,et,$),n.renderBufferDirect(w,null,O,et,E,$),E.onAfterShadow(n,E,y,w,O,et,$)}}}else if(G.visible){let q=b(E,G,I,D);E.onBeforeShadow(n,E,y,w,O,q,null),n.renderBufferDirect(w,null,O,q,E,null),E.onAfterShadow(n,E,y,w,O,q,null)}}let z=E.children;for(let O=0,G=z.length;O<G;O++)v(z[O],y,w,I,P,D)}function C(E){E.target.removeEventListener("dispose",C);for(let w in c){let I=c[w],P=E.target.uuid;P in I&&(I[P].dispose(),delete I[P])}}}function rA(n,t){function e(){let B=!1,rt=new Le,it=null,Et=new Le(0,0,0,0);return{setMask:function(_t){it!==_t&&!B&&(n.colorMask(_t,_t,_t,_t),it=_t)},setLocked:function(_t){B=_t},setClear:function(_t,bt,Ht,Qt,ct){ct===!0&&(_t*=Qt,bt*=Qt,Ht*=Qt),rt.set(_t,bt,Ht,Qt),Et.equals(rt)===!1&&(n.clearColor(_t,bt,Ht,Qt),Et.copy(rt))},reset:function(){B=!1,it=null,Et.set(-1,0,0,0)}}}function i(){let B=!1,rt=!1,it=null,Et=null,_t=null;return{setReversed:function(bt){if(rt!==bt){let Ht=t.get("EXT_clip_control");bt?Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.ZERO_TO_ONE_EXT):Ht.clipControlEXT(Ht.LOWER_LEFT_EXT,Ht.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Qt=_t;_t=null,this.setClear(Qt)}},getReversed:function(){return rt},setTest:function(bt){bt?wt(n.DEPTH_TEST):Wt(n.DEPTH_TEST)},setMask:function(bt){it!==bt&&!B&&(n.depthMask(bt),it=bt)},setFunc:function(bt){if(rt&&(bt=Xg[bt]),Et!==bt){switch(bt){case bc:n.depthFunc(n.NEVER);break;case wc:n.depthFunc(n.ALWAYS);break;case Mc:n.depthFunc(n.LESS);break;case ko:n.depthFunc(n.LEQUAL);break;case Ec:n.depthFunc(n.EQUAL);break;case Ac:n.depthFunc(n.GEQUAL);break;case Tc:n.depthFunc(n.GREATER);break;case Cc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=bt}},setLocked:function(bt){B=bt},setClear:function(bt){_t!==bt&&(_t=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){B=!1,it=null,Et=null,_t=null,rt=!1}}}function s(){let B=!1,rt=null,it=null,Et=null,_t=null,bt=null,Ht=null,Qt=null,ct=null;return{setTest:function(Bt){B||(Bt?wt(n.STENCIL_TEST):Wt(n.STENCIL_TEST))},setMask:function(Bt){rt!==Bt&&!B&&(n.stencilMask(Bt),rt=Bt)},setFunc:function(Bt,te,Rt){(it!==Bt||Et!==te||_t!==Rt)&&(n.stencilFunc(Bt,te,Rt),it=Bt,Et=te,_t=Rt)},setOp:function(Bt,te,Rt){(bt!==Bt||Ht!==te||Qt!==Rt)&&(n.stencilOp(Bt,te,Rt),bt=Bt,Ht=te,Qt=Rt)},setLocked:function(Bt){B=Bt},setClear:function(Bt){ct!==Bt&&(n.clearStencil(Bt),ct=Bt)},reset:function(){B=!1,rt=null,it=null,Et=null,_t=null,bt=null,Ht=null,Qt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},d={},u={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,b=null,v=null,C=null,E=null,y=null,w=new Zt(0,0,0),I=0,P=!1,D=null,F=null,z=null,O=null,G=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ot=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ot=parseFloat(/^WebGL (\d)/.exec($)[1]),V=ot>=1):$.indexOf("OpenGL ES")!==-1&&(ot=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),V=ot>=2);let K=null,et={},ht=n.getParameter(n.SCISSOR_BOX),ut=n.getParameter(n.VIEWPORT),Q=new Le().fromArray(ht),gt=new Le().fromArray(ut);function yt(B,rt,it,Et){let _t=new Uint8Array(4),bt=n.createTexture();n.bindTexture(B,bt),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ht=0;Ht<it;Ht++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(rt+Ht,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return bt}let Ct={};Ct[n.TEXTURE_2D]=yt(n.TEXTURE_2D,n.TEXTURE_2D,1),Ct[n.TEXTURE_CUBE_MAP]=yt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ct[n.TEXTURE_2D_ARRAY]=yt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ct[n.TEXTURE_3D]=yt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),wt(n.DEPTH_TEST),o.setFunc(ko),vn(!1),ke(Ld),wt(n.CULL_FACE),nn(qr);function wt(B){h[B]!==!0&&(n.enable(B),h[B]=!0)}function Wt(B){h[B]!==!1&&(n.disable(B),h[B]=!1)}function ae(B,rt){return u[B]!==rt?(n.bindFramebuffer(B,rt),u[B]=rt,B===n.DRAW_FRAMEBUFFER&&(u[n.FRAMEBUFFER]=rt),B===n.FRAMEBUFFER&&(u[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(B,rt){let it=p,Et=!1;if(B){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let _t=B.textures;if(it.length!==_t.length||it[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Ht=_t.length;bt<Ht;bt++)it[bt]=n.COLOR_ATTACHMENT0+bt;it.length=_t.length,Et=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Et=!0);Et&&n.drawBuffers(it)}function me(B){return _!==B?(n.useProgram(B),_=B,!0):!1}let ue={[Zr]:n.FUNC_ADD,[pg]:n.FUNC_SUBTRACT,[mg]:n.FUNC_REVERSE_SUBTRACT};ue[gg]=n.MIN,ue[_g]=n.MAX;let re={[xg]:n.ZERO,[yg]:n.ONE,[vg]:n.SRC_COLOR,[Ud]:n.SRC_ALPHA,[Ag]:n.SRC_ALPHA_SATURATE,[Mg]:n.DST_COLOR,[bg]:n.DST_ALPHA,[Sg]:n.ONE_MINUS_SRC_COLOR,[Fd]:n.ONE_MINUS_SRC_ALPHA,[Eg]:n.ONE_MINUS_DST_COLOR,[wg]:n.ONE_MINUS_DST_ALPHA,[Tg]:n.CONSTANT_COLOR,[Cg]:n.ONE_MINUS_CONSTANT_COLOR,[Rg]:n.CONSTANT_ALPHA,[Pg]:n.ONE_MINUS_CONSTANT_ALPHA};function nn(B,rt,it,Et,_t,bt,Ht,Qt,ct,Bt){if(B===qr){m===!0&&(Wt(n.BLEND),m=!1);return}if(m===!1&&(wt(n.BLEND),m=!0),B!==fg){if(B!==g||Bt!==P){if((x!==Zr||C!==Zr)&&(n.blendEquation(n.FUNC_ADD),x=Zr,C=Zr),Bt)switch(B){case Jo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dd:n.blendFunc(n.ONE,n.ONE);break;case Nd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Od:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ee("WebGLState: Invalid blending: ",B);break}else switch(B){case Jo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dd:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Nd:ee("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Od:ee("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ee("WebGLState: Invalid blending: ",B);break}b=null,v=null,E=null,y=null,w.set(0,0,0),I=0,g=B,P=Bt}return}_t=_t||rt,bt=bt||it,Ht=Ht||Et,(rt!==x||_t!==C)&&(n.blendEquationSeparate(ue[rt],ue[_t]),x=rt,C=_t),(it!==b||Et!==v||bt!==E||Ht!==y)&&(n.blendFuncSeparate(re[it],re[Et],re[bt],re[Ht]),b=it,v=Et,E=bt,y=Ht),(Qt.equals(w)===!1||ct!==I)&&(n.blendColor(Qt.r,Qt.g,Qt.b,ct),w.copy(Qt),I=ct),g=B,P=!1}function $e(B,rt){B.side===on?Wt(n.CULL_FACE):wt(n.CULL_FACE);let it=B.side===ai;rt&&(it=!it),vn(it),B.blending===Jo&&B.transparent===!1?nn(qr):nn(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Et=B.stencilWrite;a.setTest(Et),Et&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),be(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?wt(n.SAMPLE_ALPHA_TO_COVERAGE):Wt(n.SAMPLE_ALPHA_TO_COVERAGE)}function vn(B){D!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),D=B)}function ke(B){B!==hg?(wt(n.CULL_FACE),B!==F&&(B===Ld?n.cullFace(n.BACK):B===ug?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Wt(n.CULL_FACE),F=B}function On(B){B!==z&&(V&&n.lineWidth(B),z=B)}function be(B,rt,it){B?(wt(n.POLYGON_OFFSET_FILL),(O!==rt||G!==it)&&(O=rt,G=it,o.getReversed()&&(rt=-rt,it=-it),n.polygonOffset(rt,it))):Wt(n.POLYGON_OFFSET_FILL)}function Cn(B){B?wt(n.SCISSOR_TEST):Wt(n.SCISSOR_TEST)}function dn(B){B===void 0&&(B=n.TEXTURE0+q-1),K!==B&&(n.activeTexture(B),K=B)}function Sn(B,rt,it){it===void 0&&(K===null?it=n.TEXTURE0+q-1:it=K);let Et=et[it];Et===void 0&&(Et={type:void 0,texture:void 0},et[it]=Et),(Et.type!==B||Et.texture!==rt)&&(K!==it&&(n.activeTexture(it),K=it),n.bindTexture(B,rt||Ct[B]),Et.type=B,Et.texture=rt)}function k(){let B=et[K];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function jt(){try{n.compressedTexImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function le(){try{n.texSubImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Mt(){try{n.texSubImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function Ve(){try{n.compressedTexSubImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Gt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function Yt(){try{n.texStorage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function L(){try{n.texStorage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function M(){try{n.texImage2D(...arguments)}catch(B){ee("WebGLState:",B)}}function Y(){try{n.texImage3D(...arguments)}catch(B){ee("WebGLState:",B)}}function dt(B){return d[B]!==void 0?d[B]:n.getParameter(B)}function at(B,rt){d[B]!==rt&&(n.pixelStorei(B,rt),d[B]=rt)}function xt(B){Q.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function vt(B){gt.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),gt.copy(B))}function nt(B,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let Et=it.get(B);Et===void 0&&(Et=n.getUniformBlockIndex(rt,B.name),n.uniformBlockBinding(rt,Et,Et),it.set(B,Et))}function st(B,rt,it){let _t=c.get(rt).get(B);l[_t]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,it),l[_t]=it)}function pt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},K=null,et={},u={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,b=null,v=null,C=null,E=null,y=null,w=new Zt(0,0,0),I=0,P=!1,D=null,F=null,z=null,O=null,G=null,Q.set(0,0,n.canvas.width,n.canvas.height),gt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:wt,disable:Wt,bindFramebuffer:ae,drawBuffers:Vt,useProgram:me,setBlending:nn,setMaterial:$e,setFlipSided:vn,setCullFace:ke,setLineWidth:On,setPolygonOffset:be,setScissorTest:Cn,activeTexture:dn,bindTexture:Sn,unbindTexture:k,compressedTexImage2D:Pt,compressedTexImage3D:jt,texImage2D:M,texImage3D:Y,pixelStorei:at,getParameter:dt,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:Yt,texStorage3D:L,texSubImage2D:le,texSubImage3D:Mt,compressedTexSubImage2D:Ve,compressedTexSubImage3D:Gt,scissor:xt,viewport:vt,reset:pt}}function oA(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new $t,h=new WeakMap,d=new Set,u,f=new WeakMap,p=new Set,_=new FinalizationRegistry(L=>p.delete(L)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(L,M){return m?new OffscreenCanvas(L,M):Ha("canvas")}function x(L,M,Y){let dt=1,at=Yt(L);if((at.width>Y||at.height>Y)&&(dt=Y/Math.max(at.width,at.height)),dt<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let xt=Math.floor(dt*at.width),vt=Math.floor(dt*at.height);u===void 0&&(u=g(xt,vt));let nt=M?g(xt,vt):u;return nt.width=xt,nt.height=vt,nt.getContext("2d").drawImage(L,0,0,xt,vt),qt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+xt+"x"+vt+")."),nt}else return"data"in L&&qt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),L;return L}function b(L){return L.generateMipmaps}function v(L){n.generateMipmap(L)}function C(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(L,M,Y,dt,at,xt=!1){if(L!==null){if(n[L]!==void 0)return n[L];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let vt;dt&&(vt=t.get("EXT_texture_norm16"),vt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=M;if(M===n.RED&&(Y===n.FLOAT&&(nt=n.R32F),Y===n.HALF_FLOAT&&(nt=n.R16F),Y===n.UNSIGNED_BYTE&&(nt=n.R8),Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.R16_EXT),Y===n.SHORT&&vt&&(nt=vt.R16_SNORM_EXT)),M===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.R8UI),Y===n.UNSIGNED_SHORT&&(nt=n.R16UI),Y===n.UNSIGNED_INT&&(nt=n.R32UI),Y===n.BYTE&&(nt=n.R8I),Y===n.SHORT&&(nt=n.R16I),Y===n.INT&&(nt=n.R32I)),M===n.RG&&(Y===n.FLOAT&&(nt=n.RG32F),Y===n.HALF_FLOAT&&(nt=n.RG16F),Y===n.UNSIGNED_BYTE&&(nt=n.RG8),Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.RG16_EXT),Y===n.SHORT&&vt&&(nt=vt.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RG8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RG16UI),Y===n.UNSIGNED_INT&&(nt=n.RG32UI),Y===n.BYTE&&(nt=n.RG8I),Y===n.SHORT&&(nt=n.RG16I),Y===n.INT&&(nt=n.RG32I)),M===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),Y===n.UNSIGNED_INT&&(nt=n.RGB32UI),Y===n.BYTE&&(nt=n.RGB8I),Y===n.SHORT&&(nt=n.RGB16I),Y===n.INT&&(nt=n.RGB32I)),M===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),Y===n.UNSIGNED_INT&&(nt=n.RGBA32UI),Y===n.BYTE&&(nt=n.RGBA8I),Y===n.SHORT&&(nt=n.RGBA16I),Y===n.INT&&(nt=n.RGBA32I)),M===n.RGB&&(Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGB16_EXT),Y===n.SHORT&&vt&&(nt=vt.RGB16_SNORM_EXT),Y===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),Y===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),M===n.RGBA){let st=xt?Va:ve.getTransfer(at);Y===n.FLOAT&&(nt=n.RGBA32F),Y===n.HALF_FLOAT&&(nt=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(nt=st===Pe?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGBA16_EXT),Y===n.SHORT&&vt&&(nt=vt.RGBA16_SNORM_EXT),Y===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function y(L,M){let Y;return L?M===null||M===Ji||M===Jr?Y=n.DEPTH24_STENCIL8:M===zi?Y=n.DEPTH32F_STENCIL8:M===Qo&&(Y=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ji||M===Jr?Y=n.DEPTH_COMPONENT24:M===zi?Y=n.DEPTH_COMPONENT32F:M===Qo&&(Y=n.DEPTH_COMPONENT16),Y}function w(L,M){return b(L)===!0||L.isFramebufferTexture&&L.minFilter!==Gn&&L.minFilter!==ri?Math.log2(Math.max(M.width,M.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?M.mipmaps.length:1}function I(L){let M=new WeakRef(L);i.get(L).__ref=M,p.add(M),_.register(L,M,M)}function P(L){let M=i.get(L).__ref;M!==void 0&&(p.delete(M),_.unregister(M))}function D(L){z(L.target)}function F(L){O(L.target)}function z(L){L.removeEventListener("dispose",D),P(L),q(L),L.isVideoTexture&&h.delete(L),L.isHTMLTexture&&d.delete(L)}function O(L){L.removeEventListener("dispose",F),P(L),ot(L)}function G(){for(let L of p){let M=L.deref();M!==void 0&&(M.isRenderTarget===!0?O(M):z(M))}p.clear(),d.clear()}function q(L){let M=i.get(L);if(M.__webglInit===void 0)return;let Y=L.source,dt=f.get(Y);if(dt){let at=dt[M.__cacheKey];at.usedTimes--,at.usedTimes===0&&V(L),Object.keys(dt).length===0&&f.delete(Y)}i.remove(L)}function V(L){let M=i.get(L);n.deleteTexture(M.__webglTexture);let Y=L.source,dt=f.get(Y);delete dt[M.__cacheKey],o.memory.textures--}function ot(L){let M=i.get(L);M.__depthDisposeCallback&&M.__depthDisposeCallback();let Y=L.depthTexture;if(Y&&Y.renderTarget===L&&z(Y),L.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(M.__webglFramebuffer[at]))for(let xt=0;xt<M.__webglFramebuffer[at].length;xt++)n.deleteFramebuffer(M.__webglFramebuffer[at][xt]);else n.deleteFramebuffer(M.__webglFramebuffer[at]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[at])}else{if(Array.isArray(M.__webglFramebuffer))for(let at=0;at<M.__webglFramebuffer.length;at++)n.deleteFramebuffer(M.__webglFramebuffer[at]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let at=0;at<M.__webglColorRenderbuffer.length;at++)M.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[at]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let dt=L.textures;for(let at=0,xt=dt.length;at<xt;at++){let vt=i.get(dt[at]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(dt[at])}i.remove(L)}let $=0;function K(){$=0}function et(){return $}function ht(L){$=L}function ut(){let L=$;return L>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,L}function Q(L){let M=[];return M.push(L.wrapS),M.push(L.wrapT),M.push(L.wrapR||0),M.push(L.magFilter),M.push(L.minFilter),M.push(L.anisotropy),M.push(L.internalFormat),M.push(L.format),M.push(L.type),M.push(L.generateMipmaps),M.push(L.mipmapsAutoUpdate),M.push(L.premultiplyAlpha),M.push(L.flipY),M.push(L.unpackAlignment),M.push(L.colorSpace),M.join()}function gt(L,M){let Y=i.get(L);if(L.isVideoTexture&&Ve(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&Y.__version!==L.version){let dt=L.image;if(dt===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(dt.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{$e(Y,L,M);return}}else L.isExternalTexture&&(Y.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+M)}function yt(L,M){let Y=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Y.__version!==L.version){$e(Y,L,M);return}else L.isExternalTexture&&(Y.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+M)}function Ct(L,M){let Y=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&Y.__version!==L.version){$e(Y,L,M);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+M)}function wt(L,M){let Y=i.get(L);if(L.version>0&&Y.__version!==L.version){vn(Y,L,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+M)}let Wt={[Rc]:n.REPEAT,[fs]:n.CLAMP_TO_EDGE,[Pc]:n.MIRRORED_REPEAT},ae={[Gn]:n.NEAREST,[Dg]:n.NEAREST_MIPMAP_NEAREST,[cl]:n.NEAREST_MIPMAP_LINEAR,[ri]:n.LINEAR,[sh]:n.LINEAR_MIPMAP_NEAREST,[Ws]:n.LINEAR_MIPMAP_LINEAR},Vt={[Fg]:n.NEVER,[tf]:n.ALWAYS,[Bg]:n.LESS,[Kd]:n.LEQUAL,[kg]:n.EQUAL,[Qd]:n.GEQUAL,[zg]:n.GREATER,[Gg]:n.NOTEQUAL};function me(L,M){if(M.type===zi&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===ri||M.magFilter===sh||M.magFilter===cl||M.magFilter===Ws||M.minFilter===ri||M.minFilter===sh||M.minFilter===cl||M.minFilter===Ws)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,Wt[M.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,Wt[M.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,Wt[M.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,ae[M.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,ae[M.minFilter]),M.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Vt[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Gn||M.minFilter!==cl&&M.minFilter!==Ws||M.type===zi&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ue(L,M){let Y=!1;L.__webglInit===void 0&&(L.__webglInit=!0,M.addEventListener("dispose",D),I(M));let dt=M.source,at=f.get(dt);at===void 0&&(at={},f.set(dt,at));let xt=Q(M);if(xt!==L.__cacheKey){at[xt]===void 0&&(at[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),at[xt].usedTimes++;let vt=at[L.__cacheKey];vt!==void 0&&(at[L.__cacheKey].usedTimes--,vt.usedTimes===0&&V(M)),L.__cacheKey=xt,L.__webglTexture=at[xt].texture}return Y}function re(L,M,Y){return Math.floor(Math.floor(L/Y)/M)}function nn(L,M,Y,dt){let xt=L.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,Y,dt,M.data);else{xt.sort((B,rt)=>B.start-rt.start);let vt=0;for(let B=1;B<xt.length;B++){let rt=xt[vt],it=xt[B],Et=rt.start+rt.count,_t=re(it.start,M.width,4),bt=re(rt.start,M.width,4);it.start<=Et+1&&_t===bt&&re(it.start+it.count-1,M.width,4)===_t?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++vt,xt[vt]=it)}xt.length=vt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),pt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let B=0,rt=xt.length;B<rt;B++){let it=xt[B],Et=Math.floor(it.start/4),_t=Math.ceil(it.count/4),bt=Et%M.width,Ht=Math.floor(Et/M.width),Qt=_t,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ht),e.texSubImage2D(n.TEXTURE_2D,0,bt,Ht,Qt,ct,Y,dt,M.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,pt)}}function $e(L,M,Y){let dt=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(dt=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(dt=n.TEXTURE_3D);let at=ue(L,M),xt=M.source;e.bindTexture(dt,L.__webglTexture,n.TEXTURE0+Y);let vt=i.get(xt);if(xt.version!==vt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+Y),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ct=ve.getPrimaries(ve.workingColorSpace),Bt=M.colorSpace===$s?null:ve.getPrimaries(M.colorSpace),te=M.colorSpace===$s||ct===Bt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let st=x(M.image,!1,s.maxTextureSize);st=Gt(M,st);let pt=r.convert(M.format,M.colorSpace),B=r.convert(M.type),rt=E(M.internalFormat,pt,B,M.normalized,M.colorSpace,M.isVideoTexture);me(dt,M);let it,Et=M.mipmaps,_t=M.isVideoTexture!==!0,bt=vt.__version===void 0||at===!0,Ht=xt.dataReady,Qt=w(M,st);if(M.isDepthTexture)rt=y(M.format===Xs,M.type),bt&&(_t?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,pt,B,null));else if(M.isDataTexture)if(Et.length>0){_t&&bt&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ct=0,Bt=Et.length;ct<Bt;ct++)it=Et[ct],_t?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,B,it.data):e.texImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,pt,B,it.data);M.generateMipmaps=!1}else _t?(bt&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,st.width,st.height),Ht&&nn(M,st,pt,B)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,pt,B,st.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_t&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,rt,Et[0].width,Et[0].height,st.depth);for(let ct=0,Bt=Et.length;ct<Bt;ct++)if(it=Et[ct],M.format!==Qi)if(pt!==null)if(_t){if(Ht)if(M.layerUpdates.size>0){let te=df(it.width,it.height,M.format,M.type);for(let Rt of M.layerUpdates){let he=it.data.subarray(Rt*te/it.data.BYTES_PER_ELEMENT,(Rt+1)*te/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Rt,it.width,it.height,1,pt,he)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,pt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,it.width,it.height,st.depth,0,it.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Ht&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,it.width,it.height,st.depth,pt,B,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,it.width,it.height,st.depth,0,pt,B,it.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_t&&bt&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ct=0,Bt=Et.length;ct<Bt;ct++)it=Et[ct],M.format!==Qi?pt!==null?_t?Ht&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,it.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,it.width,it.height,pt,B,it.data):e.texImage2D(n.TEXTURE_2D,ct,rt,it.width,it.height,0,pt,B,it.data)}else if(M.isDataArrayTexture)if(_t){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,rt,st.width,st.height,st.depth),Ht)if(M.layerUpdates.size>0){let ct=df(st.width,st.height,M.format,M.type);for(let Bt of M.layerUpdates){let te=st.data.subarray(Bt*ct/st.data.BYTES_PER_ELEMENT,(Bt+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Bt,st.width,st.height,1,pt,B,te)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,pt,B,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,pt,B,st.data);else if(M.isData3DTexture)_t?(bt&&e.texStorage3D(n.TEXTURE_3D,Qt,rt,st.width,st.height,st.depth),Ht&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,pt,B,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,pt,B,st.data);else if(M.isFramebufferTexture){if(bt)if(_t)e.texStorage2D(n.TEXTURE_2D,Qt,rt,st.width,st.height);else{let ct=st.width,Bt=st.height;for(let te=0;te<Qt;te++)e.texImage2D(n.TEXTURE_2D,te,rt,ct,Bt,0,pt,B,null),ct>>=1,Bt>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),d.add(M),ct.onpaint=Bt=>{let te=Bt.changedElements;for(let Rt of d)te.includes(Rt.image)&&(Rt.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let te=n.RGBA,Rt=n.RGBA,he=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,te,Rt,he,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&bt){let ct=Yt(Et[0]);e.texStorage2D(n.TEXTURE_2D,Qt,rt,ct.width,ct.height)}for(let ct=0,Bt=Et.length;ct<Bt;ct++)it=Et[ct],_t?Ht&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,pt,B,it):e.texImage2D(n.TEXTURE_2D,ct,rt,pt,B,it);M.generateMipmaps=!1}else if(_t){if(bt){let ct=Yt(st);e.texStorage2D(n.TEXTURE_2D,Qt,rt,ct.width,ct.height)}Ht&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,pt,B,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,pt,B,st);b(M)&&M.mipmapsAutoUpdate===!0&&v(dt),vt.__version=xt.version,M.onUpdate&&M.onUpdate(M)}L.__version=M.version}function vn(L,M,Y){if(M.image.length!==6)return;let dt=ue(L,M),at=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+Y);let xt=i.get(at);if(at.version!==xt.__version||dt===!0){e.activeTexture(n.TEXTURE0+Y);let vt=ve.getPrimaries(ve.workingColorSpace),nt=M.colorSpace===$s?null:ve.getPrimaries(M.colorSpace),st=M.colorSpace===$s||vt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let pt=M.isCompressedTexture||M.image[0].isCompressedTexture,B=M.image[0]&&M.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!pt&&!B?rt[Rt]=x(M.image[Rt],!0,s.maxCubemapSize):rt[Rt]=B?M.image[Rt].image:M.image[Rt],rt[Rt]=Gt(M,rt[Rt]);let it=rt[0],Et=r.convert(M.format,M.colorSpace),_t=r.convert(M.type),bt=E(M.internalFormat,Et,_t,M.normalized,M.colorSpace),Ht=M.isVideoTexture!==!0,Qt=xt.__version===void 0||dt===!0,ct=at.dataReady,Bt=w(M,it);me(n.TEXTURE_CUBE_MAP,M);let te;if(M.isDepthTexture){if(bt=y(M.format===Xs,M.type),Qt)if(Ht)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,it.width,it.height,0,Et,_t,null)}else if(pt){Ht&&Qt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,bt,it.width,it.height);for(let Rt=0;Rt<6;Rt++){te=rt[Rt].mipmaps;for(let he=0;he<te.length;he++){let Ze=te[he];M.format!==Qi?Et!==null?Ht?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,Ze.width,Ze.height,Et,Ze.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,bt,Ze.width,Ze.height,0,Ze.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,Ze.width,Ze.height,Et,_t,Ze.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,bt,Ze.width,Ze.height,0,Et,_t,Ze.data)}}}else{if(te=M.mipmaps,Ht&&Qt){te.length>0&&Bt++;let Rt=Yt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Bt,bt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(B){Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,Et,_t,rt[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,rt[Rt].width,rt[Rt].height,0,Et,_t,rt[Rt].data);for(let he=0;he<te.length;he++){let Qn=te[he].image[Rt].image;Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,Qn.width,Qn.height,Et,_t,Qn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,bt,Qn.width,Qn.height,0,Et,_t,Qn.data)}}else{Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Et,_t,rt[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,bt,Et,_t,rt[Rt]);for(let he=0;he<te.length;he++){let Ze=te[he];Ht?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,Et,_t,Ze.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,bt,Et,_t,Ze.image[Rt])}}}b(M)&&M.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),xt.__version=at.version,M.onUpdate&&M.onUpdate(M)}L.__version=M.version}function ke(L,M,Y,dt,at,xt){let vt=r.convert(Y.format,Y.colorSpace),nt=r.convert(Y.type),st=E(Y.internalFormat,vt,nt,Y.normalized,Y.colorSpace),pt=i.get(M),B=i.get(Y);if(B.__renderTarget=M,!pt.__hasExternalTextures){let rt=Math.max(1,M.width>>xt),it=Math.max(1,M.height>>xt);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,xt,st,rt,it,M.depth,0,vt,nt,null):e.texImage2D(at,xt,st,rt,it,0,vt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),Mt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,dt,at,B.__webglTexture,0,le(M)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,dt,at,B.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function On(L,M,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,L),M.depthBuffer){let dt=M.depthTexture,at=dt&&dt.isDepthTexture?dt.type:null,xt=y(M.stencilBuffer,at),vt=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Mt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(M),xt,M.width,M.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(M),xt,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xt,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,L)}else{let dt=M.textures;for(let at=0;at<dt.length;at++){let xt=dt[at],vt=r.convert(xt.format,xt.colorSpace),nt=r.convert(xt.type),st=E(xt.internalFormat,vt,nt,xt.normalized,xt.colorSpace);Mt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(M),st,M.width,M.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(M),st,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,st,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function be(L,M,Y){let dt=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(M.depthTexture);at.__renderTarget=M;let xt=dt?M.depthTexture.image[0]:M.depthTexture.image;(!at.__webglTexture||xt.width!==M.width||xt.height!==M.height)&&(xt.width=M.width,xt.height=M.height,M.depthTexture.needsUpdate=!0),dt?wt(M.depthTexture,0):gt(M.depthTexture,0);let vt=at.__webglTexture,nt=le(M),st=dt?n.TEXTURE_CUBE_MAP_POSITIVE_X+Y:n.TEXTURE_2D,pt=M.depthTexture.format===Xs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===ks)Mt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,st,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,pt,st,vt,0);else if(M.depthTexture.format===Xs)Mt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pt,st,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,pt,st,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Cn(L){let M=i.get(L),Y=L.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==L.depthTexture){let dt=L.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),dt){let at=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,dt.removeEventListener("dispose",at)};dt.addEventListener("dispose",at),M.__depthDisposeCallback=at}M.__boundDepthTexture=dt}if(L.depthTexture&&!M.__autoAllocateDepthBuffer)if(Y)for(let dt=0;dt<6;dt++)be(M.__webglFramebuffer[dt],L,dt);else L.texture.mipmaps.length>0?be(M.__webglFramebuffer[0],L,0):be(M.__webglFramebuffer,L,0);else if(Y){M.__webglDepthbuffer=[];for(let dt=0;dt<6;dt++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[dt]),M.__webglDepthbuffer[dt]===void 0)M.__webglDepthbuffer[dt]=n.createRenderbuffer(),On(M.__webglDepthbuffer[dt],L,!1);else{let at=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=M.__webglDepthbuffer[dt];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),On(M.__webglDepthbuffer,L,!1);else{let at=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(L,M,Y){let dt=i.get(L);M!==void 0&&ke(dt.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&Cn(L)}function Sn(L){let M=L.texture,Y=i.get(L),dt=i.get(M);L.addEventListener("dispose",F),I(L);let at=L.textures,xt=L.isWebGLCubeRenderTarget===!0,vt=at.length>1;if(vt||(dt.__webglTexture===void 0&&(dt.__webglTexture=n.createTexture()),dt.__version=M.version,o.memory.textures++),xt){Y.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(M.mipmaps.length>0){Y.__webglFramebuffer[nt]=[];for(let st=0;st<M.mipmaps.length;st++)Y.__webglFramebuffer[nt][st]=n.createFramebuffer()}else Y.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(M.mipmaps.length>0){Y.__webglFramebuffer=[];for(let nt=0;nt<M.mipmaps.length;nt++)Y.__webglFramebuffer[nt]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(vt)for(let nt=0,st=at.length;nt<st;nt++){let pt=i.get(at[nt]);pt.__webglTexture===void 0&&(pt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&Mt(L)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let nt=0;nt<at.length;nt++){let st=at[nt];Y.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[nt]);let pt=r.convert(st.format,st.colorSpace),B=r.convert(st.type),rt=E(st.internalFormat,pt,B,st.normalized,st.colorSpace,L.isXRRenderTarget===!0),it=le(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,rt,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,Y.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),On(Y.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,dt.__webglTexture),me(n.TEXTURE_CUBE_MAP,M);for(let nt=0;nt<6;nt++)if(M.mipmaps.length>0)for(let st=0;st<M.mipmaps.length;st++)ke(Y.__webglFramebuffer[nt][st],L,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else ke(Y.__webglFramebuffer[nt],L,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);b(M)?v(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let nt=0,st=at.length;nt<st;nt++){let pt=at[nt],B=i.get(pt),rt=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(rt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,B.__webglTexture),me(rt,pt),ke(Y.__webglFramebuffer,L,pt,n.COLOR_ATTACHMENT0+nt,rt,0),b(pt)&&v(rt)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(nt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,dt.__webglTexture),me(nt,M),M.mipmaps.length>0)for(let st=0;st<M.mipmaps.length;st++)ke(Y.__webglFramebuffer[st],L,M,n.COLOR_ATTACHMENT0,nt,st);else ke(Y.__webglFramebuffer,L,M,n.COLOR_ATTACHMENT0,nt,0);b(M)?v(nt):M.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&Cn(L)}function k(L){let M=L.textures;for(let Y=0,dt=M.length;Y<dt;Y++){let at=M[Y];if(b(at)&&at.mipmapsAutoUpdate===!0){let xt=C(L),vt=i.get(at).__webglTexture;e.bindTexture(xt,vt),v(xt),e.unbindTexture()}}}let Pt=[];function jt(L){if(L.samples>0){if(Mt(L)===!1){let M=L.textures,Y=L.width,dt=L.height,at=n.COLOR_BUFFER_BIT,xt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(L),nt=M.length>1;if(nt)for(let pt=0;pt<M.length;pt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let pt=0;pt<M.length;pt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let B=i.get(M[pt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,Y,dt,0,0,Y,dt,at,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+pt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Pt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let pt=0;pt<M.length;pt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[pt]);let B=i.get(M[pt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let M=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function le(L){return Math.min(s.maxSamples,L.samples)}function Mt(L){let M=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ve(L){let M=o.render.frame;h.get(L)!==M&&(h.set(L,M),L.update())}function Gt(L,M){let Y=L.colorSpace,dt=L.format,at=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||Y!==Ga&&Y!==$s&&(ve.getTransfer(Y)===Pe?(dt!==Qi||at!==di)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ee("WebGLTextures: Unsupported texture color space:",Y)),M}function Yt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ut,this.resetTextureUnits=K,this.getTextureUnits=et,this.setTextureUnits=ht,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Ct,this.setTextureCube=wt,this.rebindTextures=dn,this.setupRenderTarget=Sn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=jt,this.setupDepthRenderbuffer=Cn,this.setupFrameBufferTexture=ke,this.useMultisampledRTT=Mt,this.dispose=G}function aA(n,t){function e(i,s=$s){let r,o=ve.getTransfer(s);if(i===di)return n.UNSIGNED_BYTE;if(i===oh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ah)return n.UNSIGNED_SHORT_5_5_5_1;if(i===qd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Zd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===$d)return n.BYTE;if(i===Yd)return n.SHORT;if(i===Qo)return n.UNSIGNED_SHORT;if(i===rh)return n.INT;if(i===Ji)return n.UNSIGNED_INT;if(i===zi)return n.FLOAT;if(i===Ki)return n.HALF_FLOAT;if(i===jd)return n.ALPHA;if(i===Jd)return n.RGB;if(i===Qi)return n.RGBA;if(i===ks)return n.DEPTH_COMPONENT;if(i===Xs)return n.DEPTH_STENCIL;if(i===lh)return n.RED;if(i===ch)return n.RED_INTEGER;if(i===Sr)return n.RG;if(i===hh)return n.RG_INTEGER;if(i===uh)return n.RGBA_INTEGER;if(i===hl||i===ul||i===dl||i===fl)if(o===Pe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===hl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===fl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===hl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===dl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===fl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===dh||i===fh||i===ph||i===mh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===dh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===fh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ph)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===mh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===gh||i===_h||i===xh||i===yh||i===vh||i===pl||i===Sh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===gh||i===_h)return o===Pe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===xh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===yh)return r.COMPRESSED_R11_EAC;if(i===vh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===pl)return r.COMPRESSED_RG11_EAC;if(i===Sh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===bh||i===wh||i===Mh||i===Eh||i===Ah||i===Th||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Oh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===bh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===wh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Mh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Eh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ah)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Th)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ch)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Rh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ph)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Ih)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Lh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Dh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Nh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Oh)return o===Pe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Uh||i===Fh||i===Bh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Uh)return o===Pe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Fh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===kh||i===zh||i===ml||i===Gh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===kh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===zh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ml)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Gh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Jr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var lA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cA=`
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

}`,Af=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Ka(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new ki({vertexShader:lA,fragmentShader:cA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new mt(new Hr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Tf=class extends ji{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new Af,g={},x=e.getContextAttributes(),b=null,v=null,C=[],E=[],y=new $t,w=null,I=null,P=new bi;P.viewport=new Le;let D=new bi;D.viewport=new Le;let F=[P,D],z=new Qc,O=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let gt=C[Q];return gt===void 0&&(gt=new Xo,C[Q]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(Q){let gt=C[Q];return gt===void 0&&(gt=new Xo,C[Q]=gt),gt.getGripSpace()},this.getHand=function(Q){let gt=C[Q];return gt===void 0&&(gt=new Xo,C[Q]=gt),gt.getHandSpace()};function q(Q){let gt=E.indexOf(Q.inputSource);if(gt===-1)return;let yt=C[gt];yt!==void 0&&(yt.update(Q.inputSource,Q.frame,c||o),yt.dispatchEvent({type:Q.type,data:Q.inputSource}))}function V(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ot);for(let Q=0;Q<C.length;Q++){let gt=E[Q];gt!==null&&(E[Q]=null,C[Q].disconnect(gt))}O=null,G=null,m.reset();for(let Q in g)delete g[Q];if(t.setRenderTarget(b),f=null,u=null,d=null,s=null,v=null,ut.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),I!==null){let Q=I.camera;Q.fov=I.fov,Q.zoom=I.zoom,Q.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ot),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Ct=null,wt=null;x.depth&&(wt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=x.stencil?Xs:ks,Ct=x.stencil?Jr:Ji);let Wt={colorFormat:e.RGBA8,depthFormat:wt,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Wt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),v=new wi(u.textureWidth,u.textureHeight,{format:Qi,type:di,depthTexture:new Vs(u.textureWidth,u.textureHeight,Ct,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{let yt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new wi(f.framebufferWidth,f.framebufferHeight,{format:Qi,type:di,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ut.setContext(s),ut.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ot(Q){for(let gt=0;gt<Q.removed.length;gt++){let yt=Q.removed[gt],Ct=E.indexOf(yt);Ct>=0&&(E[Ct]=null,C[Ct].disconnect(yt))}for(let gt=0;gt<Q.added.length;gt++){let yt=Q.added[gt],Ct=E.indexOf(yt);if(Ct===-1){for(let Wt=0;Wt<C.length;Wt++)if(Wt>=E.length){E.push(yt),Ct=Wt;break}else if(E[Wt]===null){E[Wt]=yt,Ct=Wt;break}if(Ct===-1)break}let wt=C[Ct];wt&&wt.connect(yt)}}function $(Q,gt){gt===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(gt.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let gt=Q.near,yt=Q.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(yt=m.depthFar)),z.near=D.near=P.near=gt,z.far=D.far=P.far=yt,(O!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),O=z.near,G=z.far),z.layers.mask=Q.layers.mask|6,P.layers.mask=z.layers.mask&-5,D.layers.mask=z.layers.mask&-3;let Ct=Q.parent,wt=z.cameras;$(z,Ct);for(let Wt=0;Wt<wt.length;Wt++)$(wt[Wt],Ct);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),I===null&&Q.isPerspectiveCamera&&(I={camera:Q,fov:Q.fov,zoom:Q.zoom}),K(Q,z,Ct)};function K(Q,gt,yt){yt===null?Q.matrix.copy(gt.matrixWorld):(Q.matrix.copy(yt.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(gt.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(gt.projectionMatrix),Q.projectionMatrixInverse.copy(gt.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Vo*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(Q){l=Q,u!==null&&(u.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(Q){return g[Q]};let et=null;function ht(Q,gt){if(h=gt.getViewerPose(c||o),p=gt,h!==null){let yt=h.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let Ct=!1;yt.length!==z.cameras.length&&(z.cameras.length=0,Ct=!0);for(let Vt=0;Vt<yt.length;Vt++){let me=yt[Vt],ue=null;if(f!==null)ue=f.getViewport(me);else{let nn=d.getViewSubImage(u,me);ue=nn.viewport,Vt===0&&(t.setRenderTargetTextures(v,nn.colorTexture,nn.depthStencilTexture),t.setRenderTarget(v))}let re=F[Vt];re===void 0&&(re=new bi,re.layers.enable(Vt),re.viewport=new Le,F[Vt]=re),re.matrix.fromArray(me.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(me.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(ue.x,ue.y,ue.width,ue.height),Vt===0&&(z.matrix.copy(re.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Ct===!0&&z.cameras.push(re)}let wt=s.enabledFeatures;if(wt&&wt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=i.getBinding();let Vt=d.getDepthInformation(yt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(wt&&wt.includes("camera-access")&&_){t.state.unbindTexture(),d=i.getBinding();for(let Vt=0;Vt<yt.length;Vt++){let me=yt[Vt].camera;if(me){let ue=g[me];ue||(ue=new Ka,g[me]=ue);let re=d.getCameraImage(me);ue.sourceTexture=re}}}}for(let yt=0;yt<C.length;yt++){let Ct=E[yt],wt=C[yt];Ct!==null&&wt!==void 0&&wt.update(Ct,gt,c||o)}et&&et(Q,gt),gt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:gt}),p=null}let ut=new g0;ut.setAnimationLoop(ht),this.setAnimationLoop=function(Q){et=Q},this.dispose=function(){}}},hA=new Kt,A0=new se;A0.set(-1,0,0,0,1,0,0,0,1);function uA(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,cf(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,b,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),d(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),u(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,b):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===ai&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===ai&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=t.get(g),b=x.envMap,v=x.envMapRotation;b&&(m.envMap.value=b,m.envMapRotation.value.setFromMatrix4(hA.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(A0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,b){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=b*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function d(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function u(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ai&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function dA(n,t,e,i){let s={},r={};function o(x,b){let v=b.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,b){let v=s[x.id];v===void 0&&(p(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",m));let C=b.program;i.updateUBOMapping(x,C);let E=t.render.frame;r[x.id]!==E&&(c(x),r[x.id]=E)}function l(x){let b=n.createBuffer(),v=x.__size,C=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,v,C),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function c(x){let b=s[x.id],v=x.uniforms,C=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let E=0,y=v.length;E<y;E++){let w=v[E];if(Array.isArray(w))for(let I=0,P=w.length;I<P;I++)h(w[I],E,I,C);else h(w,E,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(x,b,v,C){if(u(x,b,v,C)===!0){let E=x.__offset,y=x.value;if(Array.isArray(y)){let w=0;for(let I=0;I<y.length;I++){let P=y[I],D=_(P,!0);d(P,x.__data,w),w+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,x.__data)}}function d(x,b,v){typeof x=="number"||typeof x=="boolean"?b[v]=x:x.isMatrix3?(b[v]=x.elements[0],b[v+1]=x.elements[1],b[v+2]=x.elements[2],b[v+3]=0,b[v+4]=x.elements[3],b[v+5]=x.elements[4],b[v+6]=x.elements[5],b[v+7]=0,b[v+8]=x.elements[6],b[v+9]=x.elements[7],b[v+10]=x.elements[8],b[v+11]=0):ArrayBuffer.isView(x)?b.set(x.subarray(0,b.length-v),v):x.toArray(b,v)}function u(x,b,v,C){let E=x.value,y=b+"_"+v;if(Array.isArray(E)){C[y]===void 0&&(C[y]=[]);let w=C[y],I=!1;for(let P=0;P<E.length;P++)f(E[P],w,P)===!0&&(I=!0);return I}return f(E,C,y)}function f(x,b,v){if(b[v]===void 0)return typeof x=="number"||typeof x=="boolean"?b[v]=x:ArrayBuffer.isView(x)?b[v]=x.slice():b[v]=x.clone(),!0;{let C=b[v];if(typeof x=="number"||typeof x=="boolean"){if(C!==x)return b[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(C.equals(x)===!1)return C.copy(x),!0}}return!1}function p(x){let b=x.uniforms,v=0,C=16;for(let y=0,w=b.length;y<w;y++){let I=Array.isArray(b[y])?b[y]:[b[y]];for(let P=0,D=I.length;P<D;P++){let F=I[P],z=Array.isArray(F.value)?F.value:[F.value],O=Array.isArray(b[y])||Array.isArray(F.value),G=v;for(let V=0,ot=z.length;V<ot;V++){let $=z[V],K=_($,O),et=v%C,ht=et%K.boundary,ut=et+ht;v+=ht,ut!==0&&C-ut<K.storage&&(v+=C-ut),V===0&&(G=v),v+=K.storage}let q=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new q((v-G)/Float32Array.BYTES_PER_ELEMENT),F.__offset=G}}let E=v%C;return E>0&&(v+=C-E),x.__size=v,x.__cache={},this}function _(x,b){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",x),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let b=x.target;b.removeEventListener("dispose",m),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var fA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),gs=null;function pA(){return gs===null&&(gs=new Za(fA,16,16,Sr,Ki),gs.name="DFG_LUT",gs.minFilter=ri,gs.magFilter=ri,gs.wrapS=fs,gs.wrapT=fs,gs.generateMipmaps=!1,gs.needsUpdate=!0),gs}var na=class{constructor(t={}){let{canvas:e=Vg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=di}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,m=new Set([uh,hh,ch]),g=new Set([di,Ji,Qo,Jr,oh,ah]),x=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},C=null,E=null,y=[],w=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ms,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,D=!1,F=null,z=null,O=null,G=null;this._outputColorSpace=vi;let q=0,V=0,ot=null,$=-1,K=null,et=new Le,ht=new Le,ut=null,Q=new Zt(0),gt=0,yt=e.width,Ct=e.height,wt=1,Wt=null,ae=null,Vt=new Le(0,0,yt,Ct),me=new Le(0,0,yt,Ct),ue=!1,re=new dr,nn=new Oc,$e=!1,vn=!1,ke=new Kt,On=new R,be=new Le,Cn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},dn=!1;function Sn(){return ot===null?wt:1}let k=i;function Pt(T,H){return e.getContext(T,H)}let jt,le,Mt,Ve,Gt,Yt,L,M,Y,dt,at,xt,vt,nt,st,pt,B,rt,it,Et,_t,bt,Ht;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Bt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),k===null){let H="webgl2";if(k=Pt(H,T),k===null)throw Pt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(T){throw e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),ee("WebGLRenderer: "+T.message),T}function Qt(){jt=new E1(k),jt.init(),_t=new aA(k,jt),le=new p1(k,jt,t,_t),Mt=new rA(k,jt),le.reversedDepthBuffer&&u&&Mt.buffers.depth.setReversed(!0),z=k.createFramebuffer(),O=k.createFramebuffer(),G=k.createFramebuffer(),Ve=new C1(k),Gt=new XE,Yt=new oA(k,jt,Mt,Gt,le,_t,Ve),L=new M1(P),M=new Pb(k),bt=new d1(k,M),Y=new A1(k,M,Ve,bt),dt=new P1(k,Y,M,bt,Ve),rt=new R1(k,le,Yt),st=new m1(Gt),at=new WE(P,L,jt,le,bt,st),xt=new uA(P,Gt),vt=new YE,nt=new QE(jt),B=new u1(P,L,Mt,dt,p,l),pt=new sA(P,dt,le),Ht=new dA(k,Ve,le,Mt),it=new f1(k,jt,Ve),Et=new T1(k,jt,Ve),Ve.programs=at.programs,P.capabilities=le,P.extensions=jt,P.properties=Gt,P.renderLists=vt,P.shadowMap=pt,P.state=Mt,P.info=Ve}_!==di&&(I=new L1(_,e.width,e.height,a,s,r));let ct=new Tf(P,k);this.xr=ct,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let T=jt.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=jt.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return wt},this.setPixelRatio=function(T){T!==void 0&&(wt=T,this.setSize(yt,Ct,!1))},this.getSize=function(T){return T.set(yt,Ct)},this.setSize=function(T,H,tt=!0){if(ct.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=T,Ct=H,e.width=Math.floor(T*wt),e.height=Math.floor(H*wt),tt===!0&&(e.style.width=T+"px",e.style.height=H+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,T,H)},this.getDrawingBufferSize=function(T){return T.set(yt*wt,Ct*wt).floor()},this.setDrawingBufferSize=function(T,H,tt){yt=T,Ct=H,wt=tt,e.width=Math.floor(T*tt),e.height=Math.floor(H*tt),this.setViewport(0,0,T,H)},this.setEffects=function(T){if(_===di){ee("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let H=0;H<T.length;H++)if(T[H].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(et)},this.getViewport=function(T){return T.copy(Vt)},this.setViewport=function(T,H,tt,Z){T.isVector4?Vt.set(T.x,T.y,T.z,T.w):Vt.set(T,H,tt,Z),Mt.viewport(et.copy(Vt).multiplyScalar(Sn()).round())},this.getScissor=function(T){return T.copy(me)},this.setScissor=function(T,H,tt,Z){T.isVector4?me.set(T.x,T.y,T.z,T.w):me.set(T,H,tt,Z),Mt.scissor(ht.copy(me).multiplyScalar(Sn()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(T){Mt.setScissorTest(ue=T)},this.setOpaqueSort=function(T){Wt=T},this.setTransparentSort=function(T){ae=T},this.getClearColor=function(T){return T.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(T=!0,H=!0,tt=!0){let Z=0;if(T){let j=!1;if(ot!==null){let At=ot.texture.format;j=m.has(At)}if(j){let At=ot.texture.type,Lt=g.has(At),Tt=B.getClearColor(),Dt=B.getClearAlpha(),zt=Tt.r,ne=Tt.g,ge=Tt.b;Lt?(x[0]=zt,x[1]=ne,x[2]=ge,x[3]=Dt,k.clearBufferuiv(k.COLOR,0,x)):(b[0]=zt,b[1]=ne,b[2]=ge,b[3]=Dt,k.clearBufferiv(k.COLOR,0,b))}else Z|=k.COLOR_BUFFER_BIT}H&&(Z|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),tt&&(Z|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&k.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),F=T},this.dispose=function(){e.removeEventListener("webglcontextlost",Bt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),B.dispose(),vt.dispose(),nt.dispose(),Yt.dispose(),Gt.dispose(),L.dispose(),dt.dispose(),Y.dispose(),bt.dispose(),Ht.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Hl),ct.removeEventListener("sessionend",rs),Ts.stop()};function Bt(T){T.preventDefault(),Wa("WebGLRenderer: Context Lost."),D=!0}function te(){Wa("WebGLRenderer: Context Restored."),D=!1;let T=Ve.autoReset,H=pt.enabled,tt=pt.autoUpdate,Z=pt.needsUpdate,j=pt.type;Qt(),Ve.autoReset=T,pt.enabled=H,pt.autoUpdate=tt,pt.needsUpdate=Z,pt.type=j}function Rt(T){ee("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function he(T){let H=T.target;H.removeEventListener("dispose",he),Ze(H)}function Ze(T){Qn(T),Gt.remove(T)}function Qn(T){let H=Gt.get(T).programs;H!==void 0&&(H.forEach(function(tt){at.releaseProgram(tt)}),T.isShaderMaterial&&at.releaseShaderCache(T))}this.renderBufferDirect=function(T,H,tt,Z,j,At){H===null&&(H=Cn);let Lt=j.isMesh&&j.matrixWorld.determinantAffine()<0,Tt=Aa(T,H,tt,Z,j);Mt.setMaterial(Z,Lt);let Dt=tt.index,zt=1;if(Z.wireframe===!0){if(Dt=Y.getWireframeAttribute(tt),Dt===void 0)return;zt=2}let ne=tt.drawRange,ge=tt.attributes.position,kt=ne.start*zt,_e=(ne.start+ne.count)*zt;At!==null&&(kt=Math.max(kt,At.start*zt),_e=Math.min(_e,(At.start+At.count)*zt)),Dt!==null?(kt=Math.max(kt,0),_e=Math.min(_e,Dt.count)):ge!=null&&(kt=Math.max(kt,0),_e=Math.min(_e,ge.count));let ln=_e-kt;if(ln<0||ln===1/0)return;bt.setup(j,Z,Tt,tt,Dt);let Oe,Ue=it;if(Dt!==null&&(Oe=M.get(Dt),Ue=Et,Ue.setIndex(Oe)),j.isMesh)Z.wireframe===!0?(Mt.setLineWidth(Z.wireframeLinewidth*Sn()),Ue.setMode(k.LINES)):Ue.setMode(k.TRIANGLES);else if(j.isLine){let Rn=Z.linewidth;Rn===void 0&&(Rn=1),Mt.setLineWidth(Rn*Sn()),j.isLineSegments?Ue.setMode(k.LINES):j.isLineLoop?Ue.setMode(k.LINE_LOOP):Ue.setMode(k.LINE_STRIP)}else j.isPoints?Ue.setMode(k.POINTS):j.isSprite&&Ue.setMode(k.TRIANGLES);if(j.isBatchedMesh)if(jt.get("WEBGL_multi_draw"))Ue.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let Rn=j._multiDrawStarts,Ut=j._multiDrawCounts,bn=j._multiDrawCount,ye=Dt?M.get(Dt).bytesPerElement:1,Rs=Gt.get(Z).currentProgram.getUniforms();for(let wn=0;wn<bn;wn++)Rs.setValue(k,"_gl_DrawID",wn),Ue.render(Rn[wn]/ye,Ut[wn])}else if(j.isInstancedMesh)Ue.renderInstances(kt,ln,j.count);else if(tt.isInstancedBufferGeometry){let Rn=tt._maxInstanceCount!==void 0?tt._maxInstanceCount:1/0,Ut=Math.min(tt.instanceCount,Rn);Ue.renderInstances(kt,ln,Ut)}else Ue.render(kt,ln)};function wa(T,H,tt,Z){F!==null&&T.isNodeMaterial&&F.setObject(Z,T),$e===!0&&st.setState(T,tt,!1),T.transparent===!0&&T.side===on&&T.forceSinglePass===!1?(T.side=ai,T.needsUpdate=!0,os(T,H,Z),T.side=vr,T.needsUpdate=!0,os(T,H,Z),T.side=on):os(T,H,Z)}this.compile=function(T,H,tt=null){tt===null&&(tt=T),F!==null&&F.renderStart(T,H,tt),E=nt.get(tt),E.init(H),w.push(E),tt.traverseVisible(function(j){j.isLight&&j.layers.test(H.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),T!==tt&&T.traverseVisible(function(j){j.isLight&&j.layers.test(H.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),E.setupLights(),F!==null&&F.updateLights(E.state.lightsArray),vn=this.localClippingEnabled,$e=st.init(this.clippingPlanes,vn),$e===!0&&st.setGlobalState(this.clippingPlanes,H),F!==null&&pt.render(E.state.shadowsArray,tt,H);let Z=new Set;return T.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let At=j.material;if(At)if(Array.isArray(At))for(let Lt=0;Lt<At.length;Lt++){let Tt=At[Lt];wa(Tt,tt,H,j),Z.add(Tt)}else wa(At,tt,H,j),Z.add(At)}),E=w.pop(),F!==null&&F.renderEnd(),Z},this.compileAsync=function(T,H,tt=null){let Z=this.compile(T,H,tt);return new Promise(j=>{function At(){if(Z.forEach(function(Lt){let Dt=Gt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&Z.delete(Lt)}),Z.size===0){j(T);return}setTimeout(At,10)}jt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let co=null;function Xu(T){co&&co(T)}function Hl(){Ts.stop()}function rs(){Ts.start()}let Ts=new g0;Ts.setAnimationLoop(Xu),typeof self<"u"&&Ts.setContext(self),this.setAnimationLoop=function(T){co=T,ct.setAnimationLoop(T),T===null?Ts.stop():Ts.start()},ct.addEventListener("sessionstart",Hl),ct.addEventListener("sessionend",rs),this.render=function(T,H){if(H!==void 0&&H.isCamera!==!0){ee("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;F!==null&&F.renderStart(T,H);let tt=ct.enabled===!0&&ct.isPresenting===!0,Z=I!==null&&(ot===null||tt)&&I.begin(P,ot);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(H),H=ct.getCamera()),T.isScene===!0&&T.onBeforeRender(P,T,H,ot),E=nt.get(T,w.length),E.init(H),E.state.textureUnits=Yt.getTextureUnits(),w.push(E),ke.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?nn.setFromArrayCamera(H):re.setFromProjectionMatrix(ke,Ni,H.reversedDepth),vn=this.localClippingEnabled,$e=st.init(this.clippingPlanes,vn),C=vt.get(T,y.length),C.init(),y.push(C),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Lt=P.xr.getDepthSensingMesh();Lt!==null&&Cs(Lt,H,-1/0,P.sortObjects)}Cs(T,H,0,P.sortObjects),C.finish(),F!==null&&F.updateLights(E.state.lightsArray),P.sortObjects===!0&&C.sort(Wt,ae),dn=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,dn&&B.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),$e===!0&&st.beginShadows();let j=E.state.shadowsArray;if(pt.render(j,T,H),$e===!0&&st.endShadows(),(Z&&I.hasRenderPass())===!1){let Lt=C.opaque,Tt=C.transmissive;if(E.setupLights(),H.isArrayCamera){let Dt=H.cameras;if(Tt.length>0)for(let zt=0,ne=Dt.length;zt<ne;zt++){let ge=Dt[zt];Wi(Lt,Tt,T,ge)}dn&&B.render(T);for(let zt=0,ne=Dt.length;zt<ne;zt++){let ge=Dt[zt];Ma(C,T,ge,ge.viewport)}}else Tt.length>0&&Wi(Lt,Tt,T,H),dn&&B.render(T),Ma(C,T,H)}ot!==null&&V===0&&(Yt.updateMultisampleRenderTarget(ot),Yt.updateRenderTargetMipmap(ot)),Z&&I.end(P),T.isScene===!0&&T.onAfterRender(P,T,H),bt.resetDefaultState(),$=-1,K=null,w.pop(),w.length>0?(E=w[w.length-1],Yt.setTextureUnits(E.state.textureUnits),$e===!0&&st.setGlobalState(P.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,F!==null&&F.renderEnd()};function Cs(T,H,tt,Z){if(T.visible===!1)return;if(T.layers.test(H.layers)){if(T.isGroup)tt=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(H);else if(T.isLight)E.pushLight(T),T.castShadow&&E.pushShadow(T);else if(T.isSprite){let Lt=H.isArrayCamera?nn:re;if(!T.frustumCulled||T.intersectsFrustum(Lt)){Z&&be.setFromMatrixPosition(T.matrixWorld).applyMatrix4(ke);let Tt=dt.update(T),Dt=T.material;Dt.visible&&C.push(T,Tt,Dt,tt,be.z,null,H)}}else if(T.isMesh||T.isLine||T.isPoints){let Lt=H.isArrayCamera?nn:re;if(!T.frustumCulled||T.intersectsFrustum(Lt)){let Tt=dt.update(T),Dt=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),be.copy(T.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),be.copy(Tt.boundingSphere.center)),be.applyMatrix4(T.matrixWorld).applyMatrix4(ke)),Array.isArray(Dt)){let zt=Tt.groups;for(let ne=0,ge=zt.length;ne<ge;ne++){let kt=zt[ne],_e=Dt[kt.materialIndex];_e&&_e.visible&&C.push(T,Tt,_e,tt,be.z,kt,H)}}else Dt.visible&&C.push(T,Tt,Dt,tt,be.z,null,H)}}}let At=T.children;for(let Lt=0,Tt=At.length;Lt<Tt;Lt++)Cs(At[Lt],H,tt,Z)}function Ma(T,H,tt,Z){let{opaque:j,transmissive:At,transparent:Lt}=T;E.setupLightsView(tt),$e===!0&&st.setGlobalState(P.clippingPlanes,tt),Z&&Mt.viewport(et.copy(Z)),j.length>0&&fn(j,H,tt),At.length>0&&fn(At,H,tt),Lt.length>0&&fn(Lt,H,tt),Mt.buffers.depth.setTest(!0),Mt.buffers.depth.setMask(!0),Mt.buffers.color.setMask(!0),Mt.setPolygonOffset(!1)}function Wi(T,H,tt,Z){if((tt.isScene===!0?tt.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Z.id]===void 0){let kt=jt.has("EXT_color_buffer_half_float")||jt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Z.id]=new wi(1,1,{generateMipmaps:!0,type:kt?Ki:di,minFilter:Ws,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:ve.workingColorSpace})}let At=E.state.transmissionRenderTarget[Z.id],Lt=Z.viewport||et;At.setSize(Lt.z*P.transmissionResolutionScale,Lt.w*P.transmissionResolutionScale);let Tt=P.getRenderTarget(),Dt=P.getActiveCubeFace(),zt=P.getActiveMipmapLevel();P.setRenderTarget(At),P.getClearColor(Q),gt=P.getClearAlpha(),gt<1&&P.setClearColor(16777215,.5),P.clear(),dn&&B.render(tt);let ne=P.toneMapping;P.toneMapping=ms;let ge=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),E.setupLightsView(Z),$e===!0&&st.setGlobalState(P.clippingPlanes,Z),fn(T,tt,Z),Yt.updateMultisampleRenderTarget(At),Yt.updateRenderTargetMipmap(At),jt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let _e=0,ln=H.length;_e<ln;_e++){let Oe=H[_e],{object:Ue,geometry:Rn,material:Ut,group:bn}=Oe;if(Ut.side===on&&Ue.layers.test(Z.layers)){let ye=Ut.side;Ut.side=ai,Ut.needsUpdate=!0,xn(Ue,tt,Z,Rn,Ut,bn),Ut.side=ye,Ut.needsUpdate=!0,kt=!0}}kt===!0&&(Yt.updateMultisampleRenderTarget(At),Yt.updateRenderTargetMipmap(At))}P.setRenderTarget(Tt,Dt,zt),P.setClearColor(Q,gt),ge!==void 0&&(Z.viewport=ge),P.toneMapping=ne}function fn(T,H,tt){let Z=H.isScene===!0?H.overrideMaterial:null;for(let j=0,At=T.length;j<At;j++){let Lt=T[j],{object:Tt,geometry:Dt,group:zt}=Lt,ne=Lt.material;ne.allowOverride===!0&&Z!==null&&(ne=Z),Tt.layers.test(tt.layers)&&xn(Tt,H,tt,Dt,ne,zt)}}function xn(T,H,tt,Z,j,At){F!==null&&j.isNodeMaterial&&F.setObject(T,j),T.onBeforeRender(P,H,tt,Z,j,At),T.modelViewMatrix.multiplyMatrices(tt.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),j.onBeforeRender(P,H,tt,Z,T,At),j.transparent===!0&&j.side===on&&j.forceSinglePass===!1?(j.side=ai,j.needsUpdate=!0,P.renderBufferDirect(tt,H,Z,j,T,At),j.side=vr,j.needsUpdate=!0,P.renderBufferDirect(tt,H,Z,j,T,At),j.side=on):P.renderBufferDirect(tt,H,Z,j,T,At),T.onAfterRender(P,H,tt,Z,j,At)}function yn(T){let H=0;for(let tt of T)tt.texture!==null&&H++;return H}function os(T,H,tt){H.isScene!==!0&&(H=Cn);let Z=Gt.get(T),j=E.state.lights,At=E.state.shadowsArray,Lt=j.state.version,Tt=at.getParameters(T,j.state,At,H,tt,E.state.lightProbeGridArray),Dt=at.getProgramCacheKey(Tt),zt=Z.programs;Z.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?H.environment:null,Z.fog=H.fog;let ne=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Z.envMap=L.get(T.envMap||Z.environment,ne),Z.envMapRotation=Z.environment!==null&&T.envMap===null?H.environmentRotation:T.envMapRotation,zt===void 0&&(T.addEventListener("dispose",he),zt=new Map,Z.programs=zt,Z.programVariants=new Map);let ge=zt.get(Dt);if(ge!==void 0){if(Z.currentProgram===ge&&Z.lightsStateVersion===Lt)return Ea(T,Tt),ge}else Tt.uniforms=at.getUniforms(T),F!==null&&T.isNodeMaterial&&F.build(T,tt,Tt),T.onBeforeCompile(Tt,P),ge=at.acquireProgram(Tt,Dt),zt.set(Dt,ge),Z.uniforms=Tt.uniforms;let kt=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(kt.clippingPlanes=st.uniform),Ea(T,Tt),Z.needsLights=er(T),Z.lightsStateVersion=Lt,Z.needsLights&&(kt.ambientLightColor.value=j.state.ambient,kt.lightProbe.value=j.state.probe,kt.sunLights.value=j.state.sun,kt.sunLightShadows.value=j.state.sunShadow,kt.directionalLights.value=j.state.directional,kt.directionalLightShadows.value=j.state.directionalShadow,kt.spotLights.value=j.state.spot,kt.spotLightShadows.value=j.state.spotShadow,kt.rectAreaLights.value=j.state.rectArea,kt.ltc_1.value=j.state.rectAreaLTC1,kt.ltc_2.value=j.state.rectAreaLTC2,kt.pointLights.value=j.state.point,kt.pointLightShadows.value=j.state.pointShadow,kt.hemisphereLights.value=j.state.hemi,kt.sunShadowMatrix.value=j.state.sunShadowMatrix,kt.sunShadowCascade.value=j.state.sunShadowCascade,kt.directionalShadowMatrix.value=j.state.directionalShadowMatrix,kt.spotLightMatrix.value=j.state.spotLightMatrix,kt.spotLightMap.value=j.state.spotLightMap,kt.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=yn(E.state.lightProbeGridArray),Z.currentProgram=ge,Z.uniformsList=null,ge}function pi(T,H,tt,Z,j){let At=Gt.get(T),Lt=At.currentProgram.id+","+Z+","+j,Tt=At.programVariants.get(Lt);return Tt===void 0?(Tt=os(T,H,tt),At.programVariants.set(Lt,Tt)):(At.currentProgram=Tt,At.uniformsList=null,At.outputColorSpace=Z,At.toneMapping=j),Tt}function tr(T){if(T.uniformsList===null){let H=T.currentProgram.getUniforms();T.uniformsList=ea.seqWithValue(H.seq,T.uniforms)}return T.uniformsList}function Ea(T,H){let tt=Gt.get(T);tt.outputColorSpace=H.outputColorSpace,tt.batching=H.batching,tt.batchingColor=H.batchingColor,tt.instancing=H.instancing,tt.instancingColor=H.instancingColor,tt.instancingMorph=H.instancingMorph,tt.skinning=H.skinning,tt.morphTargets=H.morphTargets,tt.morphNormals=H.morphNormals,tt.morphColors=H.morphColors,tt.morphTargetsCount=H.morphTargetsCount,tt.numClippingPlanes=H.numClippingPlanes,tt.numIntersection=H.numClipIntersection,tt.vertexAlphas=H.vertexAlphas,tt.vertexTangents=H.vertexTangents,tt.toneMapping=H.toneMapping}function Aa(T,H,tt,Z,j){H.isScene!==!0&&(H=Cn),Yt.resetTextureUnits();let At=H.fog,Lt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?H.environment:null,Tt=ot===null?P.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:ve.workingColorSpace,Dt=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,zt=L.get(Z.envMap||Lt,Dt),ne=Z.vertexColors===!0&&!!tt.attributes.color&&tt.attributes.color.itemSize===4,ge=!!tt.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),kt=!!tt.morphAttributes.position,_e=!!tt.morphAttributes.normal,ln=!!tt.morphAttributes.color,Oe=ms;Z.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Oe=P.toneMapping);let Ue=tt.morphAttributes.position||tt.morphAttributes.normal||tt.morphAttributes.color,Rn=Ue!==void 0?Ue.length:0,Ut=Gt.get(Z),bn=E.state.lights;if($e===!0&&(vn===!0||T!==K)){let Fe=T===K&&Z.id===$;st.setState(Z,T,Fe)}let ye=!1,Rs=!1;Z.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==bn.state.version||j.isBatchedMesh&&Ut.batching===!1||!j.isBatchedMesh&&Ut.batching===!0||j.isBatchedMesh&&Ut.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ut.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ut.instancing===!1||!j.isInstancedMesh&&Ut.instancing===!0||j.isSkinnedMesh&&Ut.skinning===!1||!j.isSkinnedMesh&&Ut.skinning===!0||j.isInstancedMesh&&Ut.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ut.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ut.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ut.instancingMorph===!1&&j.morphTexture!==null||Ut.envMap!==zt||Z.fog===!0&&Ut.fog!==At||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==ne||Ut.vertexTangents!==ge||Ut.morphTargets!==kt||Ut.morphNormals!==_e||Ut.morphColors!==ln||Ut.morphTargetsCount!==Rn||Ut.numLightProbeGrids!==yn(E.state.lightProbeGridArray)?ye=!0:(Ut.outputColorSpace!==Tt||Ut.toneMapping!==Oe)&&(Rs=!0):(ye=!0,Ut.__version=Z.version);let wn=Ut.currentProgram;(ye===!0||Rs===!0)&&(wn=Rs===!0?pi(Z,H,j,Tt,Oe):os(Z,H,j),F&&Z.isNodeMaterial&&F.onUpdateProgram(Z,wn,Ut));let fo=!1,as=!1,Ps=!1,de=wn.getUniforms(),pn=Ut.uniforms;if(Mt.useProgram(wn.program)&&(fo=!0,as=!0,Ps=!0),Z.id!==$&&($=Z.id,as=!0),fo||K!==T){Mt.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),de.setValue(k,"projectionMatrix",T.projectionMatrix),de.setValue(k,"viewMatrix",T.matrixWorldInverse);let Mn=de.map.cameraPosition;Mn!==void 0&&Mn.setValue(k,On.setFromMatrixPosition(T.matrixWorld)),le.logarithmicDepthBuffer&&de.setValue(k,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&de.setValue(k,"isOrthographic",T.isOrthographicCamera===!0),K!==T&&(K=T,as=!0,Ps=!0)}if(Ut.needsLights&&(bn.state.sunShadowMap.length>0&&de.setValue(k,"sunShadowMap",bn.state.sunShadowMap,Yt),bn.state.directionalShadowMap.length>0&&de.setValue(k,"directionalShadowMap",bn.state.directionalShadowMap,Yt),bn.state.spotShadowMap.length>0&&de.setValue(k,"spotShadowMap",bn.state.spotShadowMap,Yt),bn.state.pointShadowMap.length>0&&de.setValue(k,"pointShadowMap",bn.state.pointShadowMap,Yt)),j.isSkinnedMesh){de.setOptional(k,j,"bindMatrix"),de.setOptional(k,j,"bindMatrixInverse");let Fe=j.skeleton;Fe&&(Fe.boneTexture===null&&Fe.computeBoneTexture(),de.setValue(k,"boneTexture",Fe.boneTexture,Yt))}j.isBatchedMesh&&(de.setOptional(k,j,"batchingTexture"),de.setValue(k,"batchingTexture",j._matricesTexture,Yt),de.setOptional(k,j,"batchingIdTexture"),de.setValue(k,"batchingIdTexture",j._indirectTexture,Yt),de.setOptional(k,j,"batchingColorTexture"),j._colorsTexture!==null&&de.setValue(k,"batchingColorTexture",j._colorsTexture,Yt));let ti=tt.morphAttributes;if((ti.position!==void 0||ti.normal!==void 0||ti.color!==void 0)&&rt.update(j,tt,wn),(as||Ut.receiveShadow!==j.receiveShadow)&&(Ut.receiveShadow=j.receiveShadow,de.setValue(k,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&H.environment!==null&&(pn.envMapIntensity.value=H.environmentIntensity),pn.dfgLUT!==void 0&&(pn.dfgLUT.value=pA()),as){if(de.setValue(k,"toneMappingExposure",P.toneMappingExposure),Ut.needsLights&&ho(pn,Ps),At&&Z.fog===!0&&xt.refreshFogUniforms(pn,At),xt.refreshMaterialUniforms(pn,Z,wt,Ct,E.state.transmissionRenderTarget[T.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Fe=v,Mn=0;for(let qn of E.state.lightProbeGridArray)qn.texture!==null&&(Fe.textures[Mn]=qn.texture,Fe.min[Mn]=qn.boundingBox.min,Fe.max[Mn]=qn.boundingBox.max,Fe.resolution[Mn]=qn.resolution,Mn++);for(let qn in Fe)Fe[qn].length=Mn;pn.probesSH.value=Fe.textures,pn.probesMin.value=Fe.min,pn.probesMax.value=Fe.max,pn.probesResolution.value=Fe.resolution}ea.upload(k,tr(Ut),pn,Yt)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(ea.upload(k,tr(Ut),pn,Yt),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&de.setValue(k,"center",j.center),de.setValue(k,"modelViewMatrix",j.modelViewMatrix),de.setValue(k,"normalMatrix",j.normalMatrix),de.setValue(k,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let Fe=Z.uniformsGroups;for(let Mn=0,qn=Fe.length;Mn<qn;Mn++){let Wl=Fe[Mn];Ht.update(Wl,wn),Ht.bind(Wl,wn)}}return wn}function ho(T,H){T.ambientLightColor.needsUpdate=H,T.lightProbe.needsUpdate=H,T.sunLights.needsUpdate=H,T.sunLightShadows.needsUpdate=H,T.directionalLights.needsUpdate=H,T.directionalLightShadows.needsUpdate=H,T.pointLights.needsUpdate=H,T.pointLightShadows.needsUpdate=H,T.spotLights.needsUpdate=H,T.spotLightShadows.needsUpdate=H,T.rectAreaLights.needsUpdate=H,T.hemisphereLights.needsUpdate=H}function er(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ot},this.setRenderTargetTextures=function(T,H,tt){let Z=Gt.get(T);Z.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Gt.get(T.texture).__webglTexture=H,Gt.get(T.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:tt,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,H){let tt=Gt.get(T);tt.__webglFramebuffer=H,tt.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(T,H=0,tt=0){ot=T,q=H,V=tt;let Z=null,j=!1,At=!1;if(T){let Tt=Gt.get(T);if(Tt.__useDefaultFramebuffer!==void 0){Mt.bindFramebuffer(k.FRAMEBUFFER,Tt.__webglFramebuffer),et.copy(T.viewport),ht.copy(T.scissor),ut=T.scissorTest,Mt.viewport(et),Mt.scissor(ht),Mt.setScissorTest(ut),$=-1;return}else if(Tt.__webglFramebuffer===void 0)Yt.setupRenderTarget(T);else if(Tt.__hasExternalTextures)Yt.rebindTextures(T,Gt.get(T.texture).__webglTexture,Gt.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let ne=T.depthTexture;if(Tt.__boundDepthTexture!==ne){if(ne!==null&&Gt.has(ne)&&(T.width!==ne.image.width||T.height!==ne.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Yt.setupDepthRenderbuffer(T)}}let Dt=T.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(At=!0);let zt=Gt.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(zt[H])?Z=zt[H][tt]:Z=zt[H],j=!0):T.samples>0&&Yt.useMultisampledRTT(T)===!1?Z=Gt.get(T).__webglMultisampledFramebuffer:Array.isArray(zt)?Z=zt[tt]:Z=zt,et.copy(T.viewport),ht.copy(T.scissor),ut=T.scissorTest}else et.copy(Vt).multiplyScalar(wt).floor(),ht.copy(me).multiplyScalar(wt).floor(),ut=ue;if(tt!==0&&(Z=z),Mt.bindFramebuffer(k.FRAMEBUFFER,Z)&&Mt.drawBuffers(T,Z),Mt.viewport(et),Mt.scissor(ht),Mt.setScissorTest(ut),j){let Tt=Gt.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+H,Tt.__webglTexture,tt)}else if(At){let Tt=H;for(let Dt=0;Dt<T.textures.length;Dt++){let zt=Gt.get(T.textures[Dt]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Dt,zt.__webglTexture,tt,Tt)}}else if(T!==null&&tt!==0){let Tt=Gt.get(T.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Tt.__webglTexture,tt)}$=-1};function uo(T){let H=Gt.get(T);return(H.__readFormat!==T.format||H.__readType!==T.type)&&(H.__readFormat=T.format,H.__readType=T.type,H.__formatReadable=le.textureFormatReadable(T.format),H.__typeReadable=le.textureTypeReadable(T.type)),H}this.readRenderTargetPixels=function(T,H,tt,Z,j,At,Lt,Tt=0){if(!(T&&T.isWebGLRenderTarget)){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Gt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){Mt.bindFramebuffer(k.FRAMEBUFFER,Dt);try{let zt=T.textures[Tt],ne=zt.format,ge=zt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let kt=uo(zt);if(kt.__formatReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=T.width-Z&&tt>=0&&tt<=T.height-j&&k.readPixels(H,tt,Z,j,_t.convert(ne),_t.convert(ge),At)}finally{let zt=ot!==null?Gt.get(ot).__webglFramebuffer:null;Mt.bindFramebuffer(k.FRAMEBUFFER,zt)}}},this.readRenderTargetPixelsAsync=async function(T,H,tt,Z,j,At,Lt,Tt=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Gt.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(H>=0&&H<=T.width-Z&&tt>=0&&tt<=T.height-j){Mt.bindFramebuffer(k.FRAMEBUFFER,Dt);let zt=T.textures[Tt],ne=zt.format,ge=zt.type;T.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Tt);let kt=uo(zt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let _e=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.bufferData(k.PIXEL_PACK_BUFFER,At.byteLength,k.STREAM_READ),k.readPixels(H,tt,Z,j,_t.convert(ne),_t.convert(ge),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let ln=ot!==null?Gt.get(ot).__webglFramebuffer:null;Mt.bindFramebuffer(k.FRAMEBUFFER,ln);let Oe=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Wg(k,Oe,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,_e),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,At),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(_e),k.deleteSync(Oe),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,H=null,tt=0){let Z=Math.pow(2,-tt),j=Math.floor(T.image.width*Z),At=Math.floor(T.image.height*Z),Lt=H!==null?H.x:0,Tt=H!==null?H.y:0;Yt.setTexture2D(T,0),k.copyTexSubImage2D(k.TEXTURE_2D,tt,0,0,Lt,Tt,j,At),Mt.unbindTexture()},this.copyTextureToTexture=function(T,H,tt=null,Z=null,j=0,At=0){let Lt,Tt,Dt,zt,ne,ge,kt,_e,ln,Oe=T.isCompressedTexture?T.mipmaps[At]:T.image;if(tt!==null)Lt=tt.max.x-tt.min.x,Tt=tt.max.y-tt.min.y,Dt=tt.isBox3?tt.max.z-tt.min.z:1,zt=tt.min.x,ne=tt.min.y,ge=tt.isBox3?tt.min.z:0;else{let de=Math.pow(2,-j);Lt=Math.floor(Oe.width*de),Tt=Math.floor(Oe.height*de),T.isDataArrayTexture?Dt=Oe.depth:T.isData3DTexture?Dt=Math.floor(Oe.depth*de):Dt=1,zt=0,ne=0,ge=0}Z!==null?(kt=Z.x,_e=Z.y,ln=Z.z):(kt=0,_e=0,ln=0);let Ue=_t.convert(H.format),Rn=_t.convert(H.type),Ut;H.isData3DTexture?(Yt.setTexture3D(H,0),Ut=k.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?(Yt.setTexture2DArray(H,0),Ut=k.TEXTURE_2D_ARRAY):(Yt.setTexture2D(H,0),Ut=k.TEXTURE_2D),Mt.activeTexture(k.TEXTURE0),Mt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,H.flipY),Mt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),Mt.pixelStorei(k.UNPACK_ALIGNMENT,H.unpackAlignment);let bn=Mt.getParameter(k.UNPACK_ROW_LENGTH),ye=Mt.getParameter(k.UNPACK_IMAGE_HEIGHT),Rs=Mt.getParameter(k.UNPACK_SKIP_PIXELS),wn=Mt.getParameter(k.UNPACK_SKIP_ROWS),fo=Mt.getParameter(k.UNPACK_SKIP_IMAGES);Mt.pixelStorei(k.UNPACK_ROW_LENGTH,Oe.width),Mt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Oe.height),Mt.pixelStorei(k.UNPACK_SKIP_PIXELS,zt),Mt.pixelStorei(k.UNPACK_SKIP_ROWS,ne),Mt.pixelStorei(k.UNPACK_SKIP_IMAGES,ge);let as=T.isDataArrayTexture||T.isData3DTexture,Ps=H.isDataArrayTexture||H.isData3DTexture;if(T.isDepthTexture){let de=Gt.get(T),pn=Gt.get(H),ti=Gt.get(de.__renderTarget),Fe=Gt.get(pn.__renderTarget);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,ti.__webglFramebuffer),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Mn=0;Mn<Dt;Mn++)as&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(T).__webglTexture,j,ge+Mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Gt.get(H).__webglTexture,At,ln+Mn)),k.blitFramebuffer(zt,ne,zt+Lt,ne+Tt,kt,_e,kt+Lt,_e+Tt,k.DEPTH_BUFFER_BIT,k.NEAREST);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(j!==0||T.isRenderTargetTexture||Gt.has(T)){let de=Gt.get(T),pn=Gt.get(H);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,O),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,G);for(let ti=0;ti<Dt;ti++)as?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,de.__webglTexture,j,ge+ti):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,de.__webglTexture,j),Ps?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pn.__webglTexture,At,ln+ti):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pn.__webglTexture,At),j!==0?k.blitFramebuffer(zt,ne,zt+Lt,ne+Tt,kt,_e,kt+Lt,_e+Tt,k.COLOR_BUFFER_BIT,k.NEAREST):Ps?k.copyTexSubImage3D(Ut,At,kt,_e,ln+ti,zt,ne,Lt,Tt):k.copyTexSubImage2D(Ut,At,kt,_e,zt,ne,Lt,Tt);Mt.bindFramebuffer(k.READ_FRAMEBUFFER,null),Mt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else Ps?T.isDataTexture||T.isData3DTexture?k.texSubImage3D(Ut,At,kt,_e,ln,Lt,Tt,Dt,Ue,Rn,Oe.data):H.isCompressedArrayTexture?k.compressedTexSubImage3D(Ut,At,kt,_e,ln,Lt,Tt,Dt,Ue,Oe.data):k.texSubImage3D(Ut,At,kt,_e,ln,Lt,Tt,Dt,Ue,Rn,Oe):T.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,At,kt,_e,Lt,Tt,Ue,Rn,Oe.data):T.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,At,kt,_e,Oe.width,Oe.height,Ue,Oe.data):k.texSubImage2D(k.TEXTURE_2D,At,kt,_e,Lt,Tt,Ue,Rn,Oe);Mt.pixelStorei(k.UNPACK_ROW_LENGTH,bn),Mt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ye),Mt.pixelStorei(k.UNPACK_SKIP_PIXELS,Rs),Mt.pixelStorei(k.UNPACK_SKIP_ROWS,wn),Mt.pixelStorei(k.UNPACK_SKIP_IMAGES,fo),At===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&k.generateMipmap(Ut),Mt.unbindTexture()},this.initRenderTarget=function(T){Gt.get(T).__webglFramebuffer===void 0&&Yt.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Yt.setTextureCube(T,0):T.isData3DTexture?Yt.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Yt.setTexture2DArray(T,0):Yt.setTexture2D(T,0),Mt.unbindTexture()},this.resetState=function(){q=0,V=0,ot=null,Mt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ni}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=ve._getDrawingBufferColorSpace(t),e.unpackColorSpace=ve._getUnpackColorSpace()}};var mA=["fill","fill-opacity","fill-rule","stroke","stroke-width","stroke-opacity","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","paint-order","display","font-family","font-size","font-weight","font-style","text-anchor"];function T0(n,t){let e=getComputedStyle(n);for(let i of mA)t.style.setProperty(i,e.getPropertyValue(i));t.style.removeProperty("color"),t.removeAttribute("class"),[...n.children].forEach((i,s)=>T0(i,t.children[s]))}function C0(n,t,e){let i=n.cloneNode(!0);T0(n,i);let s={x:t.x-e.x,y:t.y-e.y,width:t.width,height:t.height};for(let[r,o]of Object.entries(s))i.setAttribute(r,o);return i}function R0(n,t,e,i){let s=n.getBoundingClientRect(),{color:r,fontFamily:o,fontSize:a,fontWeight:l}=getComputedStyle(n),c={x:e-i.x,y:s.y+s.height/2+4-i.y,fill:r},h=`font-family: ${o}; font-size: ${a}; font-weight: ${l}`;return cn("text",{...c,style:h},t)}function gA(n,t,e){if(n instanceof SVGElement)return C0(n,t,e);let i=getComputedStyle(n).getPropertyValue("--swatch").trim(),[s,r]=[t.x-e.x,t.y-e.y],o=r+t.height/2;return n.matches(".dash, .thin, .thick")?cn("line",{x1:s,x2:s+t.width,y1:o,y2:o,stroke:i,"stroke-width":n.matches(".thick")?6:2.5,"stroke-opacity":n.matches(".thick")?.55:1,"stroke-dasharray":n.matches(".dash")?"5 4":null}):n.matches(".dot, .ring")?cn("circle",{cx:s+t.width/2,cy:o,r:t.width/2-1,stroke:i,fill:n.matches(".ring")?"none":i,"stroke-width":2}):cn("rect",{x:s,y:r,width:t.width,height:t.height,rx:2,fill:i})}function _A(n,t){let e=n.firstElementChild,i=e.getBoundingClientRect(),{opacity:s}=getComputedStyle(n),r=R0(n,n.textContent,i.right+6,t);return cn("g",{opacity:s},gA(e,i,t),r)}function xA(n,t){let e=[...n.querySelectorAll(".plane > h3")].map(s=>[s,s.textContent]),i=[...n.querySelectorAll(".chooser select")].map(s=>[s,s.selectedOptions[0]?.textContent??""]);return[...e,...i].map(([s,r])=>R0(s,r,s.getBoundingClientRect().left,t))}function yA(n){let t=getComputedStyle(document.documentElement);for(let e of n.querySelectorAll("[fill^='var('], [stroke^='var(']"))for(let i of["fill","stroke"]){let s=e.getAttribute(i)?.match(/^var\((--[\w-]+)\)$/)?.[1];s&&e.setAttribute(i,t.getPropertyValue(s).trim())}return n}function qh(n){let t=[...n.querySelectorAll(".chart")].filter(_=>_.toSvg),e=t.map(_=>_.getBoundingClientRect()),i=t.map(_=>_.appendChild(_.toSvg())),s=new Map(i.map((_,m)=>[_,e[m]])),r=[...n.querySelectorAll("svg.plot")].filter(_=>!_.closest("button")),o=[...n.querySelectorAll(".legend > *")],a=_=>s.get(_)??_.getBoundingClientRect(),l=n.querySelectorAll(".plane > h3, .chooser select"),c=[...r,...o,...l].map(a),h={x:Math.min(...c.map(_=>_.left))-8,y:Math.min(...c.map(_=>_.top))-8},d=Math.max(...c.map(_=>_.right))+8-h.x,u=Math.max(...c.map(_=>_.bottom))+8-h.y,f=getComputedStyle(document.documentElement).getPropertyValue("--page").trim(),p=cn("svg",{xmlns:"http://www.w3.org/2000/svg",width:d,height:u,viewBox:`0 0 ${d} ${u}`},cn("rect",{width:d,height:u,fill:f}),...xA(n,h),...o.map(_=>_A(_,h)),...r.map(_=>C0(_,a(_),h)));return i.forEach(_=>_.remove()),new XMLSerializer().serializeToString(yA(p))}var sa=(...n)=>n.map(t=>({name:t})),Cf=(n,t)=>n.map(e=>t[e]??null);function vA({series:n,x_label:t,y_label:e}){let i=n.flatMap(r=>r.x.map((o,a)=>[r.name,o,r.y[a],r.band_low?.[a]??null,r.band_high?.[a]??null,r.labels?.[a]??r.hints?.[a]??null]));return{columns:sa("series",t||"x",e||"y","band_low","band_high","label"),rows:i}}var P0=["series","value","low","high"],SA=({groups:n})=>({columns:sa("group",...P0),rows:n.flatMap(t=>t.values.map(e=>[t.name,...Cf(P0,e)]))}),I0=["name","unit","estimate","low","high","inner_low","inner_high","prior_low","prior_high","truth","display"],bA=({rows:n})=>({columns:sa(...I0),rows:n.map(t=>Cf(I0,t))}),L0=["measured","predicted","sd","predicted_sd"],wA=({planes:n})=>({columns:sa("plane","panel","group",...L0.flatMap(t=>[`${t}_x`,`${t}_y`])),rows:n.flatMap(t=>t.panels.flatMap(e=>e.arrows.map(i=>[t.name,e.title,i.group,...L0.flatMap(s=>i[s]??[null,null])])))}),D0=["measured","median","inner_low","inner_high","low","high"],MA=({components:n,groups:t})=>({columns:sa("group","row","component",...D0),rows:t.flatMap(e=>e.rows.flatMap(i=>i.values.map((s,r)=>[e.name,i.name,n[r],...Cf(D0,s)])))}),EA=({chains:n,draws:t,quantities:e})=>({columns:sa("quantity","unit","chain","draw","value"),rows:e.flatMap(i=>i.traces.flatMap((s,r)=>s.map((o,a)=>[i.name,i.unit??null,n[r],t[a],o])))}),AA=({quantities:n})=>({columns:n.map(({name:t,unit:e})=>({name:t,unit:e})),rows:n[0].draws.map((t,e)=>n.map(i=>i.draws[e]))}),TA={lines:vA,bars:SA,interval:bA,vectors:wA,predictive:MA,chains:EA,corner:AA},Rf=n=>TA[n.type]?.(n)??null,bl=(n,t)=>(n??"").toLowerCase().split(/[^a-z0-9]+/).filter(Boolean).slice(0,6).join("-")||t;var Zh=()=>typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported("video/webm");function N0(n,t){let e=document.createElement("canvas");e.width=n.width,e.height=n.height;let i=e.getContext("2d"),s=()=>{i.fillStyle=t,i.fillRect(0,0,e.width,e.height),i.drawImage(n,0,0,e.width,e.height)};s();let r={mimeType:"video/webm",videoBitsPerSecond:8e6},o=new MediaRecorder(e.captureStream(30),r),a=[];o.addEventListener("dataavailable",({data:h})=>a.push(h));let l=new Promise((h,d)=>{o.addEventListener("error",({error:u})=>d(u??new Error("no film"))),o.addEventListener("stop",()=>h(new Blob(a,{type:"video/webm"})))});return l.catch(()=>{}),o.start(),{frame:s,stop:()=>{o.state!=="inactive"&&o.stop()},film:l}}var CA=n=>{let t=n==null?"":String(n);return/[",\r\n]/.test(t)?`"${t.replace(/"/g,'""')}"`:t};function O0({columns:n,rows:t}){return[n.map(({name:i,unit:s})=>s?`${i} [${s}]`:i),...t].map(i=>i.map(CA).join(",")).join(`\r
`)+`\r
`}function ts(n,t,e){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e}));X("a",{href:i,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e3)}var jh=(n,t,e)=>X("button",{type:"button",title:`Save ${t}`,onclick:e},n);function RA(n,t){let e=bl(n.caption,n.type),i=()=>ts(`${e}.svg`,qh(t),"image/svg+xml"),s=()=>ts(`${e}.csv`,O0(Rf(n)),"text/csv");return[jh("SVG","the figure as a drawing",i),jh("CSV","the numbers of the figure",s)]}function PA(n,t){let e=X("output",{}),i=jh("WebM","the motion as a film, while it plays once",async()=>{i.disabled=!0,e.textContent="";try{let s=await n.toMovie?.();s&&ts(`${t}.webm`,s)}catch(s){e.textContent=`No film was saved: ${s.message}`}finally{i.disabled=!1}});return[i,e]}function IA(n,t){let e=t.querySelector(".scene"),i=bl(n.caption,"scene"),r=[jh("PNG","the picture as it stands",()=>e.toPng?.(o=>ts(`${i}.png`,o)))];return n.strip&&Zh()&&r.push(...PA(e,i)),r}function U0(n,t){let e=n.type==="scene"?IA(n,t):Rf(n)?RA(n,t):[];return e.length&&t.append(X("div",{class:"tools save",role:"group","aria-label":"Save"},...e)),t}var F0=(n,t)=>new Promise(e=>n.stage.picture().toBlob(i=>{ts(`${t}.png`,i),e(i.size)},"image/png"));function B0(){let n=[...document.querySelectorAll("figure.figure")].filter(t=>t.offsetParent&&[...t.querySelectorAll(".chart")].some(e=>e.toSvg));for(let t of n){let e=t.querySelector("figcaption")?.textContent??"";ts(`${bl(e,"chart")}.svg`,qh(t),"image/svg+xml")}return n.length}async function k0(n,t){let e=await n("picture.gltf");return e&&ts(`${t}.gltf`,e.gltf,"model/gltf+json"),!!e}function z0(n){if(!Zh())return null;let{stage:t}=n,e=document.createElement("canvas");e.width=t.words.width,e.height=t.words.height;let i=e.getContext("2d"),s=N0(e,rn("--page")),r=()=>{i.clearRect(0,0,e.width,e.height),i.drawImage(t.canvas,0,0,e.width,e.height),i.drawImage(t.words,0,0,e.width,e.height),s.frame()};return t.painted.push(r),t.draw(),async o=>{t.painted.splice(t.painted.indexOf(r),1),s.stop();let a=await s.film;return ts(`${o}.webm`,a),a.size}}var ra=n=>typeof n=="number"&&Number.isFinite(n),V0=n=>n.replace(/-/g,"\u2212"),Pf=n=>n.replace(/(\.\d*?)0+(?=e|$)/,"$1").replace(/\.(?=e|$)/,"").replace("e+","e");function DA(n,t){let e=Math.abs(n);return e!==0&&(e<.001||e>=1e6)?Pf(n.toExponential(t-1)):Pf(n.toPrecision(t).includes("e")?n.toFixed(0):n.toPrecision(t))}function NA(n,t){let e=n.toFixed(t);return Number(e)===0&&n!==0?Pf(n.toExponential(1)):e}var OA=1e-12,UA=1e-6;function FA(n,t,e){let i=t==null?0:UA*10**-t;return Math.abs(n)<Math.max(i,OA*e)}function pe(n,t,e=0){if(!ra(n))return"n/a";let i=FA(n,t,e)?0:n;return V0(t==null?DA(i,4):NA(i,t))}var If=n=>n.reduce((t,e)=>ra(e)?Math.max(t,Math.abs(e)):t,0);var G0=12;function BA(n,t){for(let e=0;e<G0;++e)if(n.every(i=>Math.abs(i-Number(i.toFixed(e)))<1e-6*t))return e;return G0}function Lf(n){let t=If(n),e=n.slice(1).map((l,c)=>Math.abs(l-n[c])),i=Math.min(...e.filter(l=>l>0),t||1),s=t!==0&&(t<.001||t>=1e6)?Math.floor(Math.log10(t)):0,r=n.map(l=>Math.abs(l)<1e-6*i?0:l/10**s),o=BA(r,i/10**s),a=l=>s&&l!==0?`e${s}`:"";return r.map(l=>V0(`${l.toFixed(l===0&&s?0:o)}${a(l)}`))}var kA=Math.PI/180,Gi={angle:{unit:"\xB0",scale:kA,digits:1,step:1,big:10},length:{unit:"mm",scale:.001,digits:1,step:1,big:10},force:{unit:"N",scale:1,digits:2,step:.5,big:5},share:{unit:"",scale:1,digits:2,step:.01,big:.1}},Ys=({slides:n})=>n?Gi.length:Gi.angle;function oa(n,t){if(!Number.isFinite(n))return"n/a";let{unit:e,scale:i,digits:s}=t,r=n/i,o=Math.abs(r)<.5*10**-s?0:r,a=pe(o,s);return e===""?a:e==="\xB0"?`${a}${e}`:`${a}\u202F${e}`}function H0(n,{scale:t}){let e=Number(String(n).trim().replace("\u2212","-").replace(",","."));return String(n).trim()===""||!Number.isFinite(e)?null:e*t}var _s=(n,t,e)=>Math.min(e,Math.max(t,n));var zA=0,qs=n=>`${n}-${++zA}`,De=(n,t,e={})=>X("button",{type:"button",onclick:t,...e},n);function Be(n,t,e={}){let i=De(n,async()=>{if(!i.disabled){i.disabled=!0;try{await t()}finally{i.disabled=!1}}},e);return i}function aa(n){let t=Be("Back to the world",()=>n.ask("session.mode",{mode:"world"})),e=()=>t.hidden=(n.store.scene?.mode??"world")==="world";return n.store.on(["scene"],e),e(),t}function Jh(n,t){let e=qs("file"),i=X("input",{id:e,type:"text",autocomplete:"off",placeholder:"file"}),s=()=>i.value.trim()&&t(i.value.trim());return i.addEventListener("keydown",({key:r})=>r==="Enter"&&s()),X("div",{class:"choice file-row"},X("label",{for:e},n),i,Be("Open",s,{"aria-label":`Open ${n.toLowerCase()}`}))}var qe=(n,...t)=>X("section",{class:"part","aria-label":n},X("h3",{},n),...t);function Vn(n,t){let e=qs("choice"),i=X("select",{id:e,onchange:()=>t(i.value)}),s=X("div",{class:"choice"},X("label",{for:e},n),i);return s.set=(r,o)=>{let a=r.map(c=>typeof c=="string"?{value:c,text:c}:c),l=JSON.stringify(a);i.dataset.key!==l&&(i.dataset.key=l,i.replaceChildren(...a.map(c=>X("option",{value:c.value},c.text)))),o!=null&&(i.value=o)},s.value=()=>i.value,s.select=i,s}function wl(n,t,e){let i=X("input",{type:"checkbox",onchange:()=>e(i.checked)});i.checked=t;let s=X("label",{class:"tick"},i,n);return s.box=i,s}var W0={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1};function GA(n,t,{lower:e,upper:i},s){let{step:r,big:o,scale:a}=s;return n.ctrlKey||n.altKey||n.metaKey?null:n.key==="Home"?e:n.key==="End"?i:n.key in W0?_s(t+W0[n.key]*r*a*(n.shiftKey?.1:1),e,i):n.key==="PageUp"?_s(t+o*a,e,i):n.key==="PageDown"?_s(t-o*a,e,i):null}function xs({name:n,title:t,lower:e,upper:i,quantity:s,note:r,off:o},a){let{scale:l,unit:c,digits:h}=s,d=_s(0,e,i),u=!1,f=`${oa(e,s)} to ${oa(i,s)}`,p=X("input",{type:"range",min:e/l,max:i/l,step:"any",disabled:o,"aria-label":`${n} ${c}`.trim(),title:f}),_=X("input",{type:"text",inputmode:"decimal",class:"value",disabled:o,"aria-label":`${n}, typed ${c}`.trim(),title:f,autocomplete:"off"}),m=()=>{p.value=d/l,p.setAttribute("aria-valuetext",oa(d,s)),document.activeElement!==_&&(_.value=(d/l).toFixed(h));let v=i>e?(d-e)/(i-e):0;p.style.setProperty("--full",`${100*v}%`)},g=v=>{d=_s(v,e,i),m(),a(d)};p.addEventListener("input",()=>g(Number(p.value)*l)),p.addEventListener("pointerdown",()=>u=!0);for(let v of["pointerup","pointercancel","blur","change"])p.addEventListener(v,()=>u=!1);p.addEventListener("keydown",v=>{let C=GA(v,d,{lower:e,upper:i},s);C!==null&&(v.preventDefault(),g(C))});let x=()=>{let v=H0(_.value,s);v!==null&&Math.abs(v-d)>.5*l*10**-h?g(v):_.value=(d/l).toFixed(h)};_.addEventListener("change",x),_.addEventListener("keydown",v=>{v.key==="Enter"&&x(),v.key==="Escape"&&(_.value=(d/l).toFixed(h))});let b=X("div",{class:o?"slider off":"slider"},X("span",{class:"name",title:t??n},n),p,_,X("span",{class:"unit"},c),r?X("span",{class:"note"},r):null);return b.dataset.name=n,b.set=v=>{u||!Number.isFinite(v)||(d=v,m())},b.value=()=>d,b.mark=v=>b.classList.toggle("marked",v),m(),b}function X0(n,t,e){let i=n.map(({id:a,title:l,element:c})=>(Object.assign(c,{id:`page-${a}`,tabIndex:-1}),c.setAttribute("role","tabpanel"),c.setAttribute("aria-labelledby",`tab-${a}`),De(l,()=>r(a),{role:"tab",id:`tab-${a}`,"aria-controls":`page-${a}`}))),s=null;function r(a){s!==a&&(s=a,n.forEach((l,c)=>{let h=l.id===a;l.element.hidden=!h,i[c].setAttribute("aria-selected",String(h)),i[c].tabIndex=h?0:-1}),e(a))}let o=X("div",{class:"tabs",role:"tablist","aria-label":t},...i);return o.addEventListener("keydown",({key:a})=>{let l={ArrowLeft:-1,ArrowRight:1}[a];if(!l)return;let h=(i.indexOf(document.activeElement)+l+i.length)%i.length;i[h].focus(),r(n[h].id)}),{list:o,choose:r,chosen:()=>s}}function Kh(n){if(!n?.length)return[];let t=n.map(e=>X("p",{class:"warning"},e));return t.length===1?t:[X("details",{class:"warnings"},X("summary",{},`${t.length} remarks`),...t)]}var Zs=(n,t,e)=>X("div",{class:"table-frame",tabindex:0,role:"region","aria-label":e},X("table",{},X("thead",{},X("tr",{},...n.map(i=>X("th",{scope:"col"},i)))),X("tbody",{},...t.map(i=>X("tr",{},...i.map(s=>X("td",{},s)))))));function js(n,t){for(;n.rows.length>t.length;)n.deleteRow(-1);t.forEach((e,i)=>{let s=n.rows[i]??n.insertRow();e.forEach((r,o)=>{let a=s.cells[o]??s.insertCell();a.textContent!==r&&(a.textContent=r)})})}var wr=n=>X("dl",{class:"facts"},...n.flatMap(([t,e])=>[X("dt",{},t),X("dd",{},e)]));var VA=[["Everywhere",[["Tab, Shift+Tab","go through everything that can be used"],["?","this help"],["Ctrl+Z, Ctrl+Y","undo, redo"],["Ctrl+O, Ctrl+S","open, save"],["Esc","deselect; close a dialog"],["1 to 5","the tabs Pose, Grasp, Tendons, Fit, Time"],["G, O, C","grasp, open the hand, close it"],["Space","play or pause; . one step of time"]]],["On the picture",[["drag, right drag, wheel","turn, move, zoom the view"],["click","select a body and its joint"],["arrow keys","turn the view; with a selection move it"],["+ and \u2212","zoom; with a joint selected turn that by 1\xB0 or 1 mm (Shift: 10)"],["0 or Home","show everything"],["PageUp, PageDown","the next and the previous thing"],["[ and ]","the previous and the next joint of the hand"],["x, y, z","choose the axis that arrow keys move along or turn about"],["t, r","arrow keys move, or turn, what is selected"],["Left, Right","by 1 mm or 1\xB0; Up, Down: by 10 mm or 10\xB0"],["Shift while dragging","steps of 10 mm and 15\xB0"]]],["On a slider",[["arrow keys","one step; with Shift a tenth"],["PageUp, PageDown","ten steps"],["Home, End","to the limits"]]]];function Df(n,...t){let e=qs("dialog"),i=X("dialog",{"aria-labelledby":e},X("div",{class:"dialog-head"},X("h2",{id:e},n),De("\xD7",()=>i.close(),{"aria-label":"Close"})),...t);return document.body.append(i),i}function $0(){let n=Df("Keys and gestures",X("div",{class:"help"},...VA.flatMap(([t,e])=>[X("h3",{},t),X("dl",{},...e.flatMap(([i,s])=>[X("dt",{},i),X("dd",{},s)]))])));return n.classList.add("help-dialog"),()=>n.showModal()}function Qh(n,t,e="Cancel"){return new Promise(i=>{let s=Df(n,X("div",{class:"buttons"},De(t,()=>s.close("yes"),{class:"main"}),De(e,()=>s.close(""))));s.addEventListener("close",()=>{s.remove(),i(s.returnValue==="yes")}),s.showModal()})}function Y0(n){return new Promise(t=>{let e=qs("file"),i=X("input",{id:e,type:"text",value:n,autocomplete:"off"}),s=null,r=a=>{if(!i.value.trim())return i.focus();s={name:i.value.trim(),where:a},o.close()},o=Df("Save the world",X("div",{class:"choice"},X("label",{for:e},"File"),i),X("p",{class:"hint"},"A relative path that ends in .toml, below the folder thenar was started in."),X("div",{class:"buttons"},De("Save",()=>r("here"),{class:"main",id:"save-here"}),De("Download",()=>r("download"),{id:"save-download"})));i.addEventListener("keydown",a=>a.key==="Enter"&&r("here")),o.addEventListener("close",()=>{o.remove(),t(s)}),o.showModal(),i.focus(),i.select()})}var q0=32768;function HA(n){let t="";for(let e=0;e<n.length;e+=q0)t+=String.fromCharCode(...n.subarray(e,e+q0));return btoa(t)}var WA=n=>n.some(t=>/\.(urdf|xml|mjcf)$/i.test(t))?"hand":"object";async function XA(n){let t=WA(n),e=Vn("As",s=>t=s);e.set(["object","obstacle","hand"],t);let i=X("span",{},`Import ${n.length===1?n[0]:`${n.length} files`}`,e);return await Qh(i,"Import")?t:null}async function $A(n,t){let e=t.map(({name:o})=>o);if(t.length===1&&/\.toml$/i.test(e[0])){let o=await t[0].text();await n.mayLeave()&&await n.ask("world.load",{text:o,name:e[0].replace(/\.toml$/i,"")});return}let i=await XA(e);if(!i)return;let s=await Promise.all(t.map(async o=>({name:o.name,data:HA(new Uint8Array(await o.arrayBuffer()))}))),r=await n.ask("world.import",{files:s,as:i});r&&n.notices.tell(`${r.name} was imported.`)}function Z0(n){let t=X("input",{type:"file",multiple:!0,hidden:!0,id:"files"});document.body.append(t);let e=s=>s.length&&$A(n,s).catch(r=>n.notices.error(r.message));t.addEventListener("change",()=>{e([...t.files]),t.value=""});let i=s=>document.body.classList.toggle("dropping",s);return addEventListener("dragover",s=>{s.preventDefault(),i(!0)}),addEventListener("dragleave",()=>i(!1)),addEventListener("drop",s=>{s.preventDefault(),i(!1),e([...s.dataTransfer.files])}),()=>t.click()}async function j0(n){let t=n.store.state?.world??{},e=t.file&&!t.file.startsWith("/")?t.file:`${t.name||"world"}.toml`,i=await Y0(e);if(i){if(i.where==="download"){let s=await n.ask("world.text");s&&ts(i.name.split("/").at(-1),s.toml,"application/toml");return}await n.ask("world.save",{file:i.name})&&n.notices.tell(`Saved as ${i.name}.`)}}var J0="THF1";function K0(n,t,e){if(n.byteLength!==t)throw new Error(`wanted ${e} of ${t} bytes, got ${n.byteLength}`)}function YA(n){if(n.byteLength<52)throw new Error("a frame has 52 bytes at least");let t=String.fromCharCode(...[0,1,2,3].map(i=>n.getUint8(i)));if(t!==J0)throw new Error(`wanted a frame ${J0}, got ${JSON.stringify(t)}`);let e=i=>n.getUint16(i,!0);return{revision:n.getUint32(4,!0),sequence:n.getUint32(8,!0),time:n.getFloat64(16,!0),counts:{bodies:e(24),joints:e(26),lines:e(28),contacts:e(30),arrows:e(32),points:e(34)},origin:[40,44,48].map(i=>n.getFloat32(i,!0))}}function qA(n,t){let e=s=>[0,4,8].map(r=>n.getFloat32(t+s+r,!0)),i=s=>s===65535?-1:s;return{a:i(n.getUint16(t,!0)),b:i(n.getUint16(t+2,!0)),point:e(4),normal:e(16),force:e(28),friction:n.getFloat32(t+40,!0)}}function Q0(n){let t=new DataView(n),{counts:e,origin:i,...s}=YA(t),r={bodies:28*e.bodies,joints:4*e.joints,tensions:4*e.lines,contacts:44*e.contacts,arrows:24*e.arrows,points:6*e.points};K0(t,52+Object.values(r).reduce((h,d)=>h+d),"a frame");let o=52,a={};for(let[h,d]of Object.entries(r))a[h]=o,o+=d;let l=h=>new Float32Array(n,a[h],r[h]/4),c=new Int16Array(n,a.points,3*e.points);return{...s,bodies:l("bodies"),joints:l("joints"),tensions:l("tensions"),contacts:Array.from({length:e.contacts},(h,d)=>qA(t,a.contacts+44*d)),arrows:l("arrows"),points:Float32Array.from(c,(h,d)=>i[d%3]+1e-5*h)}}function t_(n){let t=new DataView(n);if(t.byteLength<8)throw new Error("a mesh has 8 bytes at least");let[e,i]=[t.getUint32(0,!0),t.getUint32(4,!0)];K0(t,8+12*(e+i),"a mesh");let s=new Uint32Array(n,8+12*e,3*i);if(s.some(r=>r>=e))throw new Error(`a triangle names a corner beyond the ${e} of its mesh`);return{positions:new Float32Array(n,8,3*e),triangles:s}}function Js(n,t=(e,i)=>i){let e=null,i=null;async function s(){for(;i;){let{value:r,settled:o}=i;i=null,await n(r).then(o.resolve,o.reject)}e=null}return r=>{if(i)i.value=t(i.value,r);else{let a={};a.promise=new Promise((l,c)=>Object.assign(a,{resolve:l,reject:c})),i={value:r,settled:a}}let{promise:o}=i.settled;return e??(e=s()),o}}function tu(n,t,e=setTimeout,i=clearTimeout){let s=null;return()=>{s!==null&&i(s),s=e(()=>{s=null,n()},t)}}var Ml=class extends Error{constructor(t,e){super(t),this.code=e}};function e_(n,t,{openSocket:e=s=>new WebSocket(s),later:i=(s,r)=>setTimeout(s,r)}={}){let s=new Map,r=null,o=1,a=0,l=!1;function c({id:p,result:_,error:m}){let g=s.get(p);if(!g){m&&t.notice("error",m);return}s.delete(p),m?g.reject(new Ml(m.message??"failed",m.code)):g.resolve(_)}function h(p){if(typeof p!="string")return t.frame(p);let _=JSON.parse(p);_.method?t.notice(_.method,_.params??{}):c(_)}function d(){let p=[...s.values()].map(({method:m})=>m);for(let{method:m,reject:g}of s.values())g(new Ml(`the connection was lost before ${m} was answered`,"lost"));if(s.clear(),r=null,l)return;let _=Math.min(4e3,250*2**a++);t.link({connected:!1,wait:_,lost:p}),i(u,_)}function u(){if(l)return;let p=e(n);p.binaryType="arraybuffer",p.onopen=()=>{a=0,r=p,t.link({connected:!0,wait:0,lost:[]})},p.onmessage=({data:_})=>h(_),p.onclose=d}function f(p,_={}){if(!r)return Promise.reject(new Ml("thenar is not connected","not connected"));let m=o++;return new Promise((g,x)=>{s.set(m,{method:p,resolve:g,reject:x}),r.send(JSON.stringify({jsonrpc:"2.0",id:m,method:p,params:_}))})}return u(),{call:f,connected:()=>r!==null,waiting:()=>[...s].map(([p,{method:_}])=>({id:p,method:_})),close:()=>{l=!0,r?.close()}}}function n_(n){let t=[],e={...n};return e.set=i=>{let s=Object.keys(i).filter(r=>e[r]!==i[r]);Object.assign(e,i);for(let{names:r,work:o}of t)r.some(a=>s.includes(a))&&o(e)},e.on=(i,s)=>t.push({names:i,work:s}),e}var i_=(n,t)=>t.revision===n.revision&&t.bodies.length===7*n.bodies.length&&t.joints.length===n.joints.length&&t.tensions.length===n.lines.length&&t.arrows.length===6*n.arrows.length&&t.points.length===3*n.lines.reduce((e,{points:i})=>e+i,0);function Mr(n){let t=new Map;return n.bodies.forEach(({owner:e,role:i,movable:s},r)=>{let o=i==="object"||i==="obstacle"?i:"hand";t.has(e)||t.set(e,{name:e,kind:o,movable:s,bodies:[]}),t.get(e).bodies.push(r)}),[...t.values()]}var Nf=(n,t)=>n.joints.map((e,i)=>({index:i,...e})).filter(e=>t===void 0||e.hand===t);function s_(n,t){return t.led_by?n.joints.find(e=>e.hand===t.hand&&e.name===t.led_by)??t:t}function r_(n,t){let{owner:e,digit:i}=n.bodies[t];for(let s=t;s>=0;--s){let r=n.bodies[s];if(r.owner!==e||r.digit!==i)break;let o=n.joints.findLastIndex(a=>a.body===s&&!a.led_by);if(o>=0)return o}return-1}function Of(n,t,e){let i={[t.name]:e};return n==="world"?{method:"hand.set_joints",params:{hand:t.hand,joints:i}}:n==="tendons"?{method:"tendons.set",params:{posture:i}}:n==="motion"?{method:"motion.set",params:{targets:i}}:null}function eu(n,t){if(n.method!==t.method||n.params.hand!==t.params.hand)return t;let e={...t.params};for(let i of["joints","posture","targets","tensions","excitations"])(n.params[i]||t.params[i])&&(e[i]={...n.params[i],...t.params[i]});return{method:t.method,params:e}}var El=["#4c02a1","#7e03a8","#a82296","#cb4679","#e56b5d","#f89441","#fdc328"],o_=n=>[1,3,5].map(t=>parseInt(n.slice(t,t+2),16));function jA(n){let t=Math.min(1,Math.max(0,n))*(El.length-1),e=Math.min(Math.floor(t),El.length-2),[i,s]=[o_(El[e]),o_(El[e+1])];return`#${i.map((o,a)=>Math.round(o+(t-e)*(s[a]-o))).map(o=>o.toString(16).padStart(2,"0")).join("")}`}var a_=(n,{low:t,high:e})=>jA(e>t?(n-t)/(e-t):0),l_=()=>`linear-gradient(to right, ${El.join(", ")})`;function c_(){let n=X("span",{class:"number"},"0"),t=X("span",{class:"number"}),e=X("span",{class:"ramp"});e.style.background=l_();let i=X("div",{class:"color-bar",hidden:!0},X("span",{},"tension [N]"),n,e,t,X("span",{class:"dashed"},"slack")),s=X("div",{class:"force-scale",hidden:!0}),r=X("div",{class:"key-box","aria-label":"Legend",role:"group"},i,s),o="";return r.show=({tensionEnd:a,forceScale:l})=>{let c=`${a} ${l}`;c!==o&&(o=c,i.hidden=a===null,s.hidden=l===null,a!==null&&(t.textContent=pe(a)),l!==null&&(s.textContent=`arrows: 10\u202Fmm for ${pe(.01/l)}\u202FN`))},r}var JA=12e3,KA=4,QA=250;function h_(n,t){let e=X("div",{class:"notes"}),i=X("div",{class:"lost",role:"alert",hidden:!0}),s=X("div",{class:"hidden-words",role:"status","aria-live":"polite"}),r=X("progress",{max:1}),o=X("span",{class:"words"}),a=X("div",{class:"work",role:"group","aria-label":"Progress",hidden:!0},o,r,De("Stop",t,{class:"stop"}));n.append(i,a,e,s);function l(u,f){for([...e.children].find(m=>m.dataset.text===u)?.remove();e.children.length>=KA;)e.firstElementChild.remove();let _=X("div",{class:`note-box ${f}`,role:f==="error"?"alert":"status"},X("p",{},u));_.dataset.text=u,_.append(De("\xD7",()=>_.remove(),{"aria-label":"Close this note"})),e.append(_),f!=="error"&&setTimeout(()=>_.remove(),JA)}let c=null,h=({text:u,fraction:f})=>{o.textContent=u,Number.isFinite(f)?r.value=f:r.removeAttribute("value")};return{error:u=>l(u,"error"),tell:u=>l(u,"told"),say:u=>s.textContent=u,progress:h,busy:u=>{if(!u){clearTimeout(c),c=null,a.hidden=!0;return}c===null&&(h({text:u}),c=setTimeout(()=>a.hidden=!1,QA))},link:({connected:u,wait:f,lost:p=[]})=>{i.hidden=u;let _=p.length?` No answer came to ${p.join(", ")}.`:"";i.textContent=u?"":`The connection to thenar is lost; trying again in ${(f/1e3).toFixed(1)}\u202Fs.${_}`}}}var tT=({name:n})=>n.split(/[/.]/).slice(0,-1).join(" ")||"",eT=({name:n})=>n.split("/").at(-1);function nT(n,t){let e=t.map(r=>{let o=xs({name:eT(r),title:r.name,lower:r.lower,upper:r.upper,quantity:Ys(r),note:r.led_by?`goes with ${r.led_by}`:null,off:!!r.led_by||!n.canMove(r)},a=>n.moveJoint(r,a));return o.dataset.joint=r.name,o.addEventListener("focusin",()=>{r.led_by||n.select({owner:r.hand,joint:r.name},{quiet:!0})}),{joint:r,row:o}}),i=new Map;for(let{joint:r,row:o}of e){let a=tT(r);i.has(a)||i.set(a,[]),i.get(a).push(o)}let s=[...i].map(([r,o])=>r?qe(r,...o):X("div",{},...o));return{rows:e,elements:s}}function u_(n){let{store:t}=n,e=Vn("Hand",u=>n.select({owner:u})),i=X("div",{}),s=X("p",{class:"where","aria-live":"off"}),r=X("div",{class:"page pose"},e,s,i),o=[],a=()=>{let u=[...new Set(t.scene?.joints.map(p=>p.hand)??[])],f=t.selected?.owner;return u.includes(f)?f:u.includes(e.value())?e.value():u[0]},l=()=>{let u=[...new Set(t.scene?.joints.map(g=>g.hand)??[])];e.hidden=u.length<2;let f=a();e.set(u,f);let p=JSON.stringify([f,t.scene?.mode,t.scene&&Nf(t.scene,f)]);if(r.dataset.key===p)return;r.dataset.key=p;let _=nT(n,f===void 0?[]:Nf(t.scene,f));o=_.rows;let m=X("p",{class:"hint"},"There are no joints. Add a hand to pose it.");i.replaceChildren(...o.length?_.elements:[m]),c()},c=()=>{if(!(!t.frame||r.hidden))for(let{joint:u,row:f}of o)f.set(t.frame.joints[u.index])},h=()=>{for(let{joint:u,row:f}of o)f.mark(t.selected?.joint===u.name&&t.selected.owner===u.hand);l(),d()},d=()=>{let u=n.poseOf(t.selected?.owner);s.hidden=!u,u&&(s.textContent=`${t.selected.owner} stands at ${u.map(f=>(f*1e3).toFixed(1)).join(", ")} mm`)};return t.on(["scene"],l),t.on(["frame","tab"],()=>{c(),d()}),t.on(["selected"],h),l(),r}var d_=(n,t,e)=>`${t.name} ${oa(e,Ys(t))}${s_(n,t)===t?"":" (led)"}`;function nu(n,t=Math.PI/3){let e=n.index?n.toNonIndexed():n,i=e.attributes.position,s=i.count,r;if(i.isBufferAttribute===!0&&i.itemSize===3&&i.normalized===!1)r=i.array;else{r=new Float64Array(s*3);for(let v=0;v<s;v++)r[3*v+0]=i.getX(v),r[3*v+1]=i.getY(v),r[3*v+2]=i.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let v=0;v<l;v++){let C=9*v,E=r[C+0],y=r[C+1],w=r[C+2],I=r[C+3],P=r[C+4],D=r[C+5],F=r[C+6],z=r[C+7],O=r[C+8],G=F-I,q=z-P,V=O-D,ot=E-I,$=y-P,K=w-D,et=q*K-V*$,ht=V*ot-G*K,ut=G*$-q*ot,Q=1/(Math.sqrt(et*et+ht*ht+ut*ut)||1);c[3*v+0]=et*Q,c[3*v+1]=ht*Q,c[3*v+2]=ut*Q}let h=new Int32Array(s),d=new Float64Array(s*3),u=1;for(;u<s*2;)u<<=1;let f=u-1,p=new Int32Array(u),_=0;for(let v=0;v<s;v++){let C=3*v,E=Math.trunc(r[C+0]*a),y=Math.trunc(r[C+1]*a),w=Math.trunc(r[C+2]*a),I=(Math.imul(E,73856093)^Math.imul(y,19349663)^Math.imul(w,83492791))&f;for(;;){let P=p[I];if(P===0){let F=3*_;d[F+0]=E,d[F+1]=y,d[F+2]=w,p[I]=_+1,h[v]=_++;break}let D=3*(P-1);if(d[D+0]===E&&d[D+1]===y&&d[D+2]===w){h[v]=P-1;break}I=I+1&f}}let m=new Int32Array(_+1);for(let v=0;v<s;v++)m[h[v]+1]++;for(let v=0;v<_;v++)m[v+1]+=m[v];let g=new Int32Array(s),x=m.slice(0,_);for(let v=0;v<l;v++){let C=3*v;g[x[h[C+0]]++]=v,g[x[h[C+1]]++]=v,g[x[h[C+2]]++]=v}let b=new Float32Array(s*3);for(let v=0;v<l;v++){let C=3*v,E=c[C+0],y=c[C+1],w=c[C+2];for(let I=0;I<3;I++){let P=C+I,D=h[P],F=0,z=0,O=0;for(let q=m[D],V=m[D+1];q<V;q++){let ot=3*g[q],$=c[ot+0],K=c[ot+1],et=c[ot+2];E*$+y*K+w*et>o&&(F+=$,z+=K,O+=et)}let G=1/(Math.sqrt(F*F+z*z+O*O)||1);b[3*P+0]=F*G,b[3*P+1]=z*G,b[3*P+2]=O*G}}return e.setAttribute("normal",new hn(b,3,!1)),e}var iT="#dfab8f",sT="#f0d3c6",rT="#e6dcc3",oT="#7d8794",aT="#e6a83c",lT="#b9c0c9",f_=["#6fa8cf","#8dbb95","#c7a6d1","#d3a15f","#7cc0c4","#b0a37a"],cT=3813392,hT=({role:n,material:t})=>n==="link"&&(t==="skin"||t==="fingertip");function uT(n){let t=new Map;return n.map(({owner:e,digit:i})=>{if(!i)return oT;t.has(e)||t.set(e,[]);let s=t.get(e);return s.includes(i)||s.push(i),f_[s.indexOf(i)%f_.length]})}function dT(n,t){return hT(n)?iT:n.role==="nail"?sT:n.role==="bone"||n.material==="bone"?rT:n.role==="object"?aT:n.role==="obstacle"?lT:t}var fT=(n,t)=>n.lines.length>0||n.bodies.some(e=>e.owner===t&&e.role==="bone"),pT=(n,t)=>t.role==="object"?"objects":(t.role==="link"||t.role==="nail")&&fT(n,t.owner)?"hands":null;function p_(n){let t=uT(n.bodies);return n.bodies.map((e,i)=>({color:dT(e,t[i]),layer:pT(n,e)}))}var m_=n=>new Jn({color:n});function g_(n,t){let{material:e}=n;e.transparent=t<1,e.opacity=t,e.depthWrite=t===1,e.needsUpdate=!0,n.castShadow=t>.2,n.userData.veil&&(n.userData.veil.visible=t<1),n.renderOrder=t<1?3:0}var __=(n,t)=>n.material.emissive.setHex(t?cT:0);function mT({positions:n,triangles:t},e){let i=new Me;return i.setAttribute("position",new hn(n,3)),i.setIndex(new hn(t,1)),e!=null&&e>=0?nu(i,e*Math.PI/180):(i.computeVertexNormals(),i)}function x_(n){let t=new Map,e=({mesh:r,crease:o})=>`${r} ${o}`;return{get:r=>{let o=e(r);if(!t.has(o)){let a=n(r.mesh).then(l=>mT(t_(l),r.crease));a.catch(()=>t.delete(o)),t.set(o,a)}return t.get(o)},keepOnly:r=>{let o=new Set(r.filter(({mesh:a})=>a).map(e));for(let[a,l]of t)o.has(a)||(t.delete(a),l.then(c=>c.dispose()).catch(()=>{}))},size:()=>t.size}}function gT(n){let t=new mt(n,new oi({colorWrite:!1}));return t.renderOrder=2,t.visible=!1,t.raycast=()=>{},t}function _T(n,t,e,i){let s=new mt(t,m_(e.color));return s.castShadow=s.receiveShadow=!0,s.userData={body:i,layer:e.layer,veil:gT(t)},n.add(s,s.userData.veil),n.userData.mesh=s,s}function xT(n){for(let t of n.groups)t.userData.mesh?.material.dispose(),t.userData.mesh?.userData.veil.material.dispose(),t.removeFromParent()}function y_(n,t,e){let i={groups:[],hidden:new Set,opacities:{hands:.5,objects:1}},s=null,r=null,o=l=>{let{layer:c}=l.userData;g_(l,c?i.opacities[c]:1),__(l,s.bodies[l.userData.body].owner===r)},a=()=>i.groups.flatMap(({userData:l})=>l.mesh??[]);return i.show=l=>{let c=l.bodies.map(({name:d,owner:u},f)=>{let p=new Te;p.name=d,p.visible=!i.hidden.has(u);let _=i.groups.find(m=>m.name===d);return _&&p.position.copy(_.position),_&&p.quaternion.copy(_.quaternion),p.userData.index=f,p});xT(i),s=l,i.groups=c;for(let d of c)n.add(d);let h=p_(s);return t.keepOnly(s.bodies),Promise.all(s.bodies.map(async(d,u)=>{if(!d.mesh)return;let f=await t.get(d);s===l&&(o(_T(c[u],f,h[u],u)),e())}))},i.pose=({bodies:l})=>i.groups.forEach((c,h)=>{let d=7*h;c.position.set(l[d],l[d+1],l[d+2]);let[u,f,p,_]=[3,4,5,6].map(m=>l[d+m]);c.quaternion.set(f,p,_,u),c.updateMatrixWorld()}),i.hide=(l,c)=>{c?i.hidden.add(l):i.hidden.delete(l),i.groups.forEach((h,d)=>{h.visible=!i.hidden.has(s.bodies[d].owner)})},i.select=l=>{r=l,a().forEach(o)},i.opacity=(l,c)=>{i.opacities[l]=c,a().forEach(o)},i.meshes=()=>a().filter(l=>l.parent.visible),i.box=()=>{let l={object:new tn,obstacle:new tn};for(let c of a()){c.geometry.boundingBox??c.geometry.computeBoundingBox(),c.parent.updateMatrixWorld();let{role:h}=s.bodies[c.userData.body];l[h==="obstacle"?h:"object"].union(c.geometry.boundingBox.clone().applyMatrix4(c.parent.matrixWorld))}return l.object.isEmpty()?l.obstacle:l.object},i}var v_=["#0072b2","#d55e00","#cc79a7","#e69f00","#56b4e9"];function yT(n){let t=Uint8Array.from(atob(n),e=>e.charCodeAt(0));if(t.length%24)throw new Error(`wanted 24 bytes a segment of a cloud, got ${t.length}`);return new Float32Array(t.buffer)}function S_(n){let t=[];return{show:(i,s)=>{for(let r of t)r.geometry.dispose(),r.material.dispose(),r.removeFromParent();t=i.clouds.map(({name:r,body:o,segments:a},l)=>{let c=new Me;c.setAttribute("position",new hn(yT(a),3));let d={color:v_[l%v_.length],transparent:!0,opacity:.22,depthWrite:!1},u=new Gs(c,new Fi(d));return u.name=r,u.renderOrder=1,u.raycast=()=>{},(s[o]??n).add(u),u})}}}function Er(n){let t=10**Math.floor(Math.log10(n));return[1,2,5,10].find(i=>i*t>=n*(1-1e-9))*t}var vT=1e-12;function b_(n,t=0,e=vT){let i=n.filter(Number.isFinite);if(i.length===0)return[0,1];let s=i.reduce((l,c)=>Math.min(l,c)),r=i.reduce((l,c)=>Math.max(l,c)),o=Math.max(Math.abs(s),Math.abs(r)),a=r-s>e*o?t*(r-s):.5*(o||1);return[s-a,r+a]}var ST=new R(0,1,0),w_="#b3261e",M_="#d55e00",bT={force:M_,moment:"#993366",axis:"#777777",measured:"#0072b2",predicted:"#d55e00",disturbance:"#cc79a7"},wT=.3,MT=.05;function E_(n,t,e){if(!(n>0))return e??null;let i=wT*t/n;return e&&e<=i*1.001&&e>.2*i?e:1/Er(1/i)}function iu(n,t,e){let i=null,s=r=>(i&&i.instanceMatrix.count>=r||(i?.removeFromParent(),i?.dispose(),i=new zs(t,e,Math.max(16,2*r)),i.instanceMatrix.setUsage(nf),i.frustumCulled=!1,i.raycast=()=>{},i.renderOrder=e.depthTest?4:6,n.add(i)),i);return r=>{let o=s(r.length);r.forEach((a,l)=>o.setMatrixAt(l,a)),o.count=r.length,o.instanceMatrix.needsUpdate=!0}}function Uf(n,t,e){let i=t.clone().sub(n),s=i.length(),r=new Ie().setFromUnitVectors(ST,i.divideScalar(s||1)),o=n.clone().add(t).multiplyScalar(.5);return new Kt().compose(o,r,new R(e,s,e))}function A_(n,t){let e={depthTest:!1,transparent:!0},i=new Jn({...e,color:t,emissive:t,emissiveIntensity:.25}),s=iu(n,new Ge(1,1,1,10),i),r=iu(n,new Bi(1,1,14),i);return(o,a)=>{let l=o.filter(({vector:c})=>c.lengthSq()>0).map(({from:c,vector:h})=>{let d=c.clone().add(h),u=Math.min(7*a,.5*h.length()),f=d.clone().addScaledVector(h.clone().normalize(),-u);return[Uf(c,f,a),Uf(f,d,2.6*a)]});s(l.map(([c])=>c)),r(l.map(([,c])=>c))}}function ET({point:n,normal:t,friction:e},i){let s=new R(...n),r=s.clone().addScaledVector(new R(...t),i);return Uf(r,s,Math.min(e,2)*i)}function T_(n){let t=new Te,e=new Te;n.add(t),t.add(e);let i=new oi({color:w_,depthTest:!1,transparent:!0}),s=iu(t,new ui(1,12,8),i),r=new Jn({color:w_,transparent:!0,opacity:.3,side:on,depthWrite:!1}),o=iu(e,new Bi(1,1,24,1,!0),r),a=A_(t,M_),l={contacts:!0,cones:!0,forces:!0},c=null;return{pose:({contacts:d},u)=>{let f=l.contacts?d:[],p=.006*u;s(f.map(({point:g})=>new Kt().makeTranslation(...g).scale(new R(p,p,p)))),o(l.cones?f.filter(g=>g.friction>0).map(g=>ET(g,MT*u)):[]);let _=Math.max(0,...d.map(({force:g})=>Math.hypot(...g)));c=E_(_,u,c);let m=l.forces&&c?d:[];return a(m.map(({point:g,force:x})=>({from:new R(...g),vector:new R(...x).multiplyScalar(c)})),.004*u),{forceScale:_>0?c:null}},show:l,forget:()=>c=null}}function C_(n){let t=new Te;n.add(t);let e=Object.fromEntries(Object.entries(bT).map(([l,c])=>[l,A_(t,c)])),i=[],s={},r=l=>l==="moment"?"moment":l==="axis"?"axis":"force";return{show:l=>{i=l.arrows.map(({kind:c,name:h})=>({kind:c,unit:/moment/i.test(h)?"moment":r(c)})),s={}},pose:({arrows:l},c)=>{let h=i.map(({kind:d,unit:u},f)=>({kind:d,unit:u,from:new R(...l.subarray(6*f,6*f+3)),vector:new R(...l.subarray(6*f+3,6*f+6))}));for(let d of["force","moment"]){let u=Math.max(0,...h.filter(f=>f.unit===d).map(f=>f.vector.length()));s[d]=E_(u,c,s[d])}for(let{unit:d,vector:u}of h)d==="axis"?u.setLength(u.length()>0?.12*c:0):u.multiplyScalar(s[d]??0);for(let[d,u]of Object.entries(e))u(h.filter(f=>f.kind===d),(d==="axis"?.0022:.0045)*c);return h.map(({from:d,vector:u},f)=>({position:d.clone().add(u),long:u.length(),i:f})).filter(({long:d})=>d>0)},visible:l=>t.visible=l}}var es=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Al=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Ff=(n,t,e)=>[n[0]+e*t[0],n[1]+e*t[1],n[2]+e*t[2]],Bf=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],su=n=>{let t=Math.hypot(...n);return t>0?n.map(e=>e/t):[0,0,0]};function I_(n,t){let e=su(n),i=Ff(t,e,-es(t,e));return Math.hypot(...i)>1e-6*(1+Math.hypot(...t))?su(i):su(Bf(e,Math.abs(e[0])<.9?[1,0,0]:[0,1,0]))}var AT=.12;function R_({axis:n,point:t},{from:e,way:i}){let s=es(n,i);if(Math.abs(s)<AT)return null;let r=es(Al(t,e),n)/s;return Al(Ff(e,i,r),t)}var TT=(n,t,e)=>Math.atan2(es(Bf(n,t),e),es(n,t));function L_(n,t,e){if(n.slides)return CT(n,t);let i=R_(n,t),s=0;return i?r=>{let o=R_(n,r);return o&&(s+=TT(i,o,n.axis),i=o),s}:RT(n,t,e)}function P_({axis:n,point:t},{from:e,way:i}){let s=Al(e,t),r=es(n,i),o=1-r*r;return o<1e-6?null:(es(s,n)-r*es(s,i))/o}function CT(n,t){let e=P_(n,t)??0,i=e;return s=>(i=P_(n,s)??i,i-e)}function RT({axis:n,point:t},e,i){let s=su(Bf(n,e.way)),r=({from:a,way:l})=>{let c=es(Al(t,a),e.way)/(es(l,e.way)||1);return es(Al(Ff(a,l,c),t),s)},o=r(e);return a=>-(r(a)-o)/i}var PT=84,Ar={range:"#0072b2",end:"#d55e00",needle:"#e69f00"},D_=2*Math.PI,Tr=(n,t=1)=>new oi({color:n,opacity:t,transparent:!0,depthTest:!1,depthWrite:!1,side:on});function Cr(n,t,e=10){let i=new mt(n,t);return i.renderOrder=e,i}function N_(n){let t=Cr(new Ye(.3,.05,.02),Tr(Ar.end),12);return t.position.set(.95*Math.cos(n),.95*Math.sin(n),0),t.rotation.z=n,t}function IT({lower:n,upper:t}){let e=new Te,i=new Te,s=Math.min(D_,t-n);i.add(Cr(new Wr(.82,1,64,1,n,s),Tr(Ar.range,.55))),i.add(Cr(new Wr(0,.82,64,1,n,s),Tr(Ar.range,.12))),s<D_&&i.add(N_(n),N_(t)),e.add(Cr(new Wr(.9,.92,64),Tr(Ar.range,.5)));let r=Cr(new Ye(1.1,.06,.02),Tr(Ar.needle),13);r.position.x=.55;let o=new mt(new Ai(.91,.16,8,48));return o.visible=!1,e.add(i,r,o),{group:e,grip:o,turn:a=>i.rotation.z=-a}}function LT({lower:n,upper:t}){let e=new Te,i=new Te,s=Cr(new Ye(.08,.08,1),Tr(Ar.range,.55));i.add(s);let r=[1,-1].map(c=>{let h=Cr(new Bi(.16,.36,16),Tr(Ar.needle),13);return h.rotation.x=c*Math.PI/2,h.position.z=.9*c,h}),o=Cr(new Ge(.04,.04,1.6,8),Tr(Ar.needle),13);o.rotation.x=Math.PI/2;let a=new mt(new Ge(.22,.22,2.2,8).rotateX(Math.PI/2));return a.visible=!1,e.add(i,o,...r,a),{group:e,grip:a,turn:(c,h)=>{s.scale.z=(t-n)/h,s.position.z=((t+n)/2-c)/h}}}function O_(n,t){let e=new R(...n.axis).normalize(),i=t.userData.mesh,r=(i?i.geometry.boundingSphere.center.toArray():[0,0,0]).map((l,c)=>l-n.point[c]),o=new R(...I_(n.axis,r)),a=new Kt().makeBasis(o,new R().crossVectors(e,o),e);return a.setPosition(...n.point),a.premultiply(t.matrixWorld)}function U_(n,t){let e=null;function i(){if(!e)return;let{joint:c,body:h,shape:d}=e;h.userData.mesh&&(h.userData.mesh.geometry.boundingSphere??h.userData.mesh.geometry.computeBoundingSphere());let{camera:u,width:f}=n;e.radius=PT*(u.right-u.left)/(f*u.zoom);let p=new R,_=new Ie;O_(c,h).decompose(p,_,new R),d.group.position.copy(p),d.group.quaternion.copy(_),d.group.scale.setScalar(e.radius),d.turn(e.value,e.radius),d.group.updateMatrixWorld()}n.preparing.push(i);function s(c,h,d){e&&e.shape.group.removeFromParent(),e=c?{joint:c,body:h,value:d,shape:c.slides?LT(c):IT(c),radius:1}:null,e&&n.scene.add(e.shape.group),e&&i(),n.draw()}let r=({ray:c})=>({from:c.origin.toArray(),way:c.direction.toArray()});function o(c){if(!e||c.intersectObject(e.shape.grip).length===0)return null;let{joint:h,body:d,value:u,radius:f}=e,p=O_(h,d),_=new R().setFromMatrixColumn(p,2).normalize().toArray(),m=new R().setFromMatrixPosition(p).toArray(),g=L_({axis:_,point:m,slides:h.slides},r(c),f);return x=>t(h,_s(u+g(r(x)),h.lower,h.upper))}return{show:s,tell:c=>{e&&(e.value=c)},grab:o,rim:c=>(e.joint.slides?new R(0,0,.9+c):new R(.91*Math.cos(c),.91*Math.sin(c),0)).applyMatrix4(e.shape.group.matrixWorld),held:()=>e}}It.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new $t},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};li.line={uniforms:_l.merge([It.common,It.fog,It.line]),vertexShader:`
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
		`};var ys=class extends ki{constructor(t){super({type:"LineMaterial",uniforms:_l.clone(li.line.uniforms),vertexShader:li.line.vertexShader,fragmentShader:li.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var F_=new tn,ru=new R,Rr=class extends ol{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new ie(t,3)),this.setAttribute("uv",new ie(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,i=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),i.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new _r(e,6,1);return this.setAttribute("instanceStart",new Ui(i,3,0)),this.setAttribute("instanceEnd",new Ui(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new _r(e,6,1);return this.setAttribute("instanceColorStart",new Ui(i,3,0)),this.setAttribute("instanceColorEnd",new Ui(i,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new tl(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new tn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),F_.setFromBufferAttribute(e),this.boundingBox.union(F_))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Mi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)ru.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(ru)),ru.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(ru));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var kf=new Le,B_=new R,k_=new R,Wn=new Le,Xn=new Le,vs=new Le,zf=new R,Gf=new Kt,$n=new al,z_=new R,ou=new tn,au=new Mi,Ss=new Le,bs,Qr;function G_(n,t,e){return Ss.set(0,0,-t,1).applyMatrix4(n.projectionMatrix),Ss.multiplyScalar(1/Ss.w),Ss.x=Qr/e.width,Ss.y=Qr/e.height,Ss.applyMatrix4(n.projectionMatrixInverse),Ss.multiplyScalar(1/Ss.w),Math.abs(Math.max(Ss.x,Ss.y))}function DT(n,t){let e=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){$n.start.fromBufferAttribute(s,a),$n.end.fromBufferAttribute(r,a),$n.applyMatrix4(e);let c=new R,h=new R;bs.distanceSqToSegment($n.start,$n.end,h,c),h.distanceTo(c)<Qr*.5&&t.push({point:h,pointOnLine:c,distance:bs.origin.distanceTo(h),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function NT(n,t,e){let i=t.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),d=-t.near;bs.at(1,vs),vs.w=1,vs.applyMatrix4(t.matrixWorldInverse),vs.applyMatrix4(i),vs.multiplyScalar(1/vs.w),vs.x*=r.x/2,vs.y*=r.y/2,vs.z=0,zf.copy(vs),Gf.multiplyMatrices(t.matrixWorldInverse,o);for(let u=0,f=h;u<f;u++){if(Wn.fromBufferAttribute(l,u),Xn.fromBufferAttribute(c,u),Wn.w=1,Xn.w=1,Wn.applyMatrix4(Gf),Xn.applyMatrix4(Gf),Wn.z>d&&Xn.z>d)continue;if(Wn.z>d){let b=Wn.z-Xn.z,v=(Wn.z-d)/b;Wn.lerp(Xn,v)}else if(Xn.z>d){let b=Xn.z-Wn.z,v=(Xn.z-d)/b;Xn.lerp(Wn,v)}Wn.applyMatrix4(i),Xn.applyMatrix4(i),Wn.multiplyScalar(1/Wn.w),Xn.multiplyScalar(1/Xn.w),Wn.x*=r.x/2,Wn.y*=r.y/2,Xn.x*=r.x/2,Xn.y*=r.y/2,$n.start.copy(Wn),$n.start.z=0,$n.end.copy(Xn),$n.end.z=0;let _=$n.closestPointToPointParameter(zf,!0);$n.at(_,z_);let m=ta.lerp(Wn.z,Xn.z,_),g=m>=-1&&m<=1,x=zf.distanceTo(z_)<Qr*.5;if(g&&x){$n.start.fromBufferAttribute(l,u),$n.end.fromBufferAttribute(c,u),$n.start.applyMatrix4(o),$n.end.applyMatrix4(o);let b=new R,v=new R;bs.distanceSqToSegment($n.start,$n.end,v,b),e.push({point:v,pointOnLine:b,distance:bs.origin.distanceTo(v),object:n,face:null,faceIndex:u,uv:null,uv1:null})}}}var la=class extends mt{constructor(t=new Rr,e=new ys({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,i=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)B_.fromBufferAttribute(e,o),k_.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+B_.distanceTo(k_);let r=new _r(s,2,1);return t.setAttribute("instanceDistanceStart",new Ui(r,1,0)),t.setAttribute("instanceDistanceEnd",new Ui(r,1,1)),this}raycast(t,e){let i=this.material.worldUnits,s=t.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;bs=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Qr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),au.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Qr*.5;else{let d=Math.max(s.near,au.distanceToPoint(bs.origin));c=G_(s,d,l.resolution)}if(au.radius+=c,bs.intersectsSphere(au)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),ou.copy(a.boundingBox).applyMatrix4(o);let h;if(i)h=Qr*.5;else{let d=Math.max(s.near,ou.distanceToPoint(bs.origin));h=G_(s,d,l.resolution)}ou.expandByScalar(h),bs.intersectsBox(ou)!==!1&&(i?DT(this,e):NT(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(kf),this.material.uniforms.resolution.value.set(kf.z,kf.w))}};var V_=1,OT=new Zt("#8a8f99"),Vf={taut:{linewidth:3.2},slack:{linewidth:2.2,dashed:!0,dashSize:.003,gapSize:.002},unknown:{linewidth:1.3}},UT=n=>Number.isNaN(n)?"unknown":n>0?"taut":"slack";function FT(n){let t=n.reduce((e,i)=>i>e?i:e,0);return t>V_?Er(t):V_}function BT(n,t){let e=new Rr;e.setPositions(new Float32Array(6*t)),e.setColors(new Float32Array(6*t));let i=new la(e,new ys({...Vf[n],vertexColors:!0}));return i.computeLineDistances(),i.frustumCulled=!1,i.renderOrder=1,i.raycast=()=>{},i}function kT(n,t,e,i,s,r){let{instanceStart:o,instanceColorStart:a,instanceDistanceStart:l}=n.geometry.attributes,c=o.data.array;c.set(e,6*t),c.set(i,6*t+3);let h=a.data.array;s.toArray(h,6*t),s.toArray(h,6*t+3);let d=l.data.array,u=Math.hypot(i[0]-e[0],i[1]-e[1],i[2]-e[2]);return d[2*t]=r,d[2*t+1]=r+u,r+u}function zT(n,t){let{instanceStart:e,instanceColorStart:i,instanceDistanceStart:s}=n.geometry.attributes;n.geometry.instanceCount=t,n.visible=t>0;for(let{data:r}of[e,i,s])r.needsUpdate=!0}function H_(n){let t=new Te;n.add(t);let e=[],i={};return{show:a=>{e=a.lines;for(let c of Object.values(i))c.geometry.dispose(),c.material.dispose();t.clear();let l=e.reduce((c,{points:h})=>c+Math.max(0,h-1),0);i=l?Object.fromEntries(Object.keys(Vf).map(c=>[c,BT(c,l)])):{};for(let c of Object.values(i))t.add(c)},pose:({tensions:a,points:l})=>{if(!Object.keys(i).length)return null;let c=FT(a),h={taut:0,slack:0,unknown:0},d=new Zt,u=0;e.forEach((f,p)=>{let _=UT(a[p]);_==="taut"?d.set(a_(a[p],{low:0,high:c})):d.copy(OT);let m=0;for(let g=u;g<u+f.points-1;++g){let[x,b]=[l.subarray(3*g,3*g+3),l.subarray(3*g+3,3*g+6)];m=kT(i[_],h[_]++,x,b,d,m)}u+=f.points});for(let[f,p]of Object.entries(h))zT(i[f],p);return h.taut+h.slack>0?c:null},sharpen:a=>Object.entries(i).forEach(([l,{material:c}])=>{c.linewidth=Vf[l].linewidth*a}),visible:a=>t.visible=a}}var GT=new Zt("#0072b2"),VT=new Zt("#e69f00"),HT=6e-4;function W_(n,t){let e=null,i=()=>{e&&(e.removeFromParent(),e.geometry.dispose(),e.material.dispose(),e.dispose(),e=null)};return{show:r=>{if(i(),!r.length)return;let o=r.reduce((c,{pressure:h})=>Math.max(c,h),0)||1,a={depthTest:!1,transparent:!0},l=new oi(a);e=new zs(new ui(1,8,6),l,r.length),r.forEach(({point:c,pressure:h,sticks:d},u)=>{let f=HT*(.25+.75*Math.sqrt(Math.max(0,h)/o)),p=new R(f,f,f);e.setMatrixAt(u,new Kt().makeTranslation(...c).scale(p)),e.setColorAt(u,d?GT:VT)}),e.frustumCulled=!1,e.raycast=()=>{},e.renderOrder=7,n.add(e),t()},clear:i}}var to=new $r,_n=new R,Pr=new R,an=new Ie,X_={X:new R(1,0,0),Y:new R(0,1,0),Z:new R(0,0,1)},Hf={type:"change"},$_={type:"mouseDown",mode:null},Y_={type:"mouseUp",mode:null},q_={type:"objectChange"},du=class extends Yr{constructor(t,e=null){super(void 0,e);let i=new Xf(this);this._root=i;let s=new $f;this._gizmo=s,i.add(s);let r=new Yf;this._plane=r,i.add(r);let o=this;function a(b,v){let C=v;Object.defineProperty(o,b,{get:function(){return C!==void 0?C:v},set:function(E){C!==E&&(C=E,r[b]=E,s[b]=E,o.dispatchEvent({type:b+"-changed",value:E}),o.dispatchEvent(Hf))}}),o[b]=v,r[b]=v,s[b]=v}a("camera",t),a("object",void 0),a("enabled",!0),a("axis",null),a("mode","translate"),a("translationSnap",null),a("rotationSnap",null),a("scaleSnap",null),a("space","world"),a("size",1),this.viewport=null,a("dragging",!1),a("showX",!0),a("showY",!0),a("showZ",!0),a("showXY",!0),a("showYZ",!0),a("showXZ",!0),a("showXYZE",!0),a("showE",!0),a("minX",-1/0),a("maxX",1/0),a("minY",-1/0),a("maxY",1/0),a("minZ",-1/0),a("maxZ",1/0);let l=new R,c=new R,h=new Ie,d=new Ie,u=new R,f=new Ie,p=new R,_=new R,m=new R,g=0,x=new R;a("worldPosition",l),a("worldPositionStart",c),a("worldQuaternion",h),a("worldQuaternionStart",d),a("cameraPosition",u),a("cameraQuaternion",f),a("pointStart",p),a("pointEnd",_),a("rotationAxis",m),a("rotationAngle",g),a("eye",x),this._offset=new R,this._startNorm=new R,this._endNorm=new R,this._cameraScale=new R,this._parentPosition=new R,this._parentQuaternion=new Ie,this._parentQuaternionInv=new Ie,this._parentScale=new R,this._worldScaleStart=new R,this._worldQuaternionInv=new Ie,this._worldScale=new R,this._positionStart=new R,this._quaternionStart=new Ie,this._scaleStart=new R,this._getPointer=WT.bind(this),this._onPointerDown=$T.bind(this),this._onPointerHover=XT.bind(this),this._onPointerMove=YT.bind(this),this._onPointerUp=qT.bind(this),e!==null&&this.connect(e)}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointermove",this._onPointerHover),this.domElement.addEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerHover),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.style.touchAction=""}getHelper(){return this._root}pointerHover(t){if(this.object===void 0||this.dragging===!0)return;t!==null&&to.setFromCamera(t,this.camera);let e=Wf(this._gizmo.picker[this.mode],to);e?this.axis=e.object.name:this.axis=null}pointerDown(t){if(!(this.object===void 0||this.dragging===!0||t!=null&&t.button!==0)&&this.axis!==null){t!==null&&to.setFromCamera(t,this.camera);let e=Wf(this._plane,to,!0);e&&(this.object.updateMatrixWorld(),this.object.parent.updateMatrixWorld(),this._positionStart.copy(this.object.position),this._quaternionStart.copy(this.object.quaternion),this._scaleStart.copy(this.object.scale),this.object.matrixWorld.decompose(this.worldPositionStart,this.worldQuaternionStart,this._worldScaleStart),this.pointStart.copy(e.point).sub(this.worldPositionStart)),this.dragging=!0,$_.mode=this.mode,this.dispatchEvent($_)}}pointerMove(t){let e=this.axis,i=this.mode,s=this.object,r=this.space;if(i==="scale"?r="local":(e==="E"||e==="XYZE"||e==="XYZ")&&(r="world"),s===void 0||e===null||this.dragging===!1||t!==null&&t.button!==-1)return;t!==null&&to.setFromCamera(t,this.camera);let o=Wf(this._plane,to,!0);if(o){if(this.pointEnd.copy(o.point).sub(this.worldPositionStart),i==="translate")this._offset.copy(this.pointEnd).sub(this.pointStart),r==="local"&&e!=="XYZ"&&this._offset.applyQuaternion(this._worldQuaternionInv),e.indexOf("X")===-1&&(this._offset.x=0),e.indexOf("Y")===-1&&(this._offset.y=0),e.indexOf("Z")===-1&&(this._offset.z=0),r==="local"&&e!=="XYZ"?this._offset.applyQuaternion(this._quaternionStart).divide(this._parentScale):this._offset.applyQuaternion(this._parentQuaternionInv).divide(this._parentScale),s.position.copy(this._offset).add(this._positionStart),this.translationSnap&&(r==="local"&&(s.position.applyQuaternion(an.copy(this._quaternionStart).invert()),e.search("X")!==-1&&(s.position.x=Math.round(s.position.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(s.position.y=Math.round(s.position.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(s.position.z=Math.round(s.position.z/this.translationSnap)*this.translationSnap),s.position.applyQuaternion(this._quaternionStart)),r==="world"&&(s.getWorldPosition(_n),e.search("X")!==-1&&(_n.x=Math.round(_n.x/this.translationSnap)*this.translationSnap),e.search("Y")!==-1&&(_n.y=Math.round(_n.y/this.translationSnap)*this.translationSnap),e.search("Z")!==-1&&(_n.z=Math.round(_n.z/this.translationSnap)*this.translationSnap),s.position.copy(s.parent.worldToLocal(_n)))),s.position.x=Math.max(this.minX,Math.min(this.maxX,s.position.x)),s.position.y=Math.max(this.minY,Math.min(this.maxY,s.position.y)),s.position.z=Math.max(this.minZ,Math.min(this.maxZ,s.position.z));else if(i==="scale"){if(e.search("XYZ")!==-1){let a=this.pointEnd.length()/this.pointStart.length();this.pointEnd.dot(this.pointStart)<0&&(a*=-1),Pr.set(a,a,a)}else _n.copy(this.pointStart),Pr.copy(this.pointEnd),_n.applyQuaternion(this._worldQuaternionInv),Pr.applyQuaternion(this._worldQuaternionInv),Pr.divide(_n),e.search("X")===-1&&(Pr.x=1),e.search("Y")===-1&&(Pr.y=1),e.search("Z")===-1&&(Pr.z=1);s.scale.copy(this._scaleStart).multiply(Pr),this.scaleSnap&&(e.search("X")!==-1&&(s.scale.x=Math.round(s.scale.x/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Y")!==-1&&(s.scale.y=Math.round(s.scale.y/this.scaleSnap)*this.scaleSnap||this.scaleSnap),e.search("Z")!==-1&&(s.scale.z=Math.round(s.scale.z/this.scaleSnap)*this.scaleSnap||this.scaleSnap))}else if(i==="rotate"){this._offset.copy(this.pointEnd).sub(this.pointStart);let a=20/this.worldPosition.distanceTo(_n.setFromMatrixPosition(this.camera.matrixWorld)),l=!1;e==="XYZE"?(this.rotationAxis.copy(this._offset).cross(this.eye).normalize(),this.rotationAngle=this._offset.dot(_n.copy(this.rotationAxis).cross(this.eye))*a):(e==="X"||e==="Y"||e==="Z")&&(this.rotationAxis.copy(X_[e]),_n.copy(X_[e]),r==="local"&&_n.applyQuaternion(this.worldQuaternion),_n.cross(this.eye),_n.length()===0?l=!0:this.rotationAngle=this._offset.dot(_n.normalize())*a),(e==="E"||l)&&(this.rotationAxis.copy(this.eye),this.rotationAngle=this.pointEnd.angleTo(this.pointStart),this._startNorm.copy(this.pointStart).normalize(),this._endNorm.copy(this.pointEnd).normalize(),this.rotationAngle*=this._endNorm.cross(this._startNorm).dot(this.eye)<0?1:-1),this.rotationSnap&&(this.rotationAngle=Math.round(this.rotationAngle/this.rotationSnap)*this.rotationSnap),r==="local"&&e!=="E"&&e!=="XYZE"?(s.quaternion.copy(this._quaternionStart),s.quaternion.multiply(an.setFromAxisAngle(this.rotationAxis,this.rotationAngle)).normalize()):(this.rotationAxis.applyQuaternion(this._parentQuaternionInv),s.quaternion.copy(an.setFromAxisAngle(this.rotationAxis,this.rotationAngle)),s.quaternion.multiply(this._quaternionStart).normalize())}this.dispatchEvent(Hf),this.dispatchEvent(q_)}}pointerUp(t){t!==null&&t.button!==0||(this.dragging&&this.axis!==null&&(Y_.mode=this.mode,this.dispatchEvent(Y_)),this.dragging=!1,this.axis=null)}dispose(){this.disconnect(),this._root.dispose()}attach(t){return this.object=t,this._root.visible=!0,this}detach(){return this.object=void 0,this.axis=null,this._root.visible=!1,this}reset(){this.enabled&&this.dragging&&(this.object.position.copy(this._positionStart),this.object.quaternion.copy(this._quaternionStart),this.object.scale.copy(this._scaleStart),this.dispatchEvent(Hf),this.dispatchEvent(q_),this.pointStart.copy(this.pointEnd))}getRaycaster(){return to}getMode(){return this.mode}setMode(t){this.mode=t}setTranslationSnap(t){this.translationSnap=t}setRotationSnap(t){this.rotationSnap=t}setScaleSnap(t){this.scaleSnap=t}setSize(t){this.size=t}setSpace(t){this.space=t}setColors(t,e,i,s){let r=this._gizmo.materialLib;r.xAxis.color.set(t),r.yAxis.color.set(e),r.zAxis.color.set(i),r.active.color.set(s),r.xAxisTransparent.color.set(t),r.yAxisTransparent.color.set(e),r.zAxisTransparent.color.set(i),r.activeTransparent.color.set(s),r.xAxis._color&&r.xAxis._color.set(t),r.yAxis._color&&r.yAxis._color.set(e),r.zAxis._color&&r.zAxis._color.set(i),r.active._color&&r.active._color.set(s),r.xAxisTransparent._color&&r.xAxisTransparent._color.set(t),r.yAxisTransparent._color&&r.yAxisTransparent._color.set(e),r.zAxisTransparent._color&&r.zAxisTransparent._color.set(i),r.activeTransparent._color&&r.activeTransparent._color.set(s)}};function WT(n){if(this.domElement.ownerDocument.pointerLockElement)return{x:0,y:0,button:n.button};{let t=this.domElement.getBoundingClientRect(),e=this.viewport,i,s,r,o;return e!==null?(i=e.x,s=t.height-e.y-e.w,r=e.z,o=e.w):(i=0,s=0,r=t.width,o=t.height),{x:(n.clientX-t.left-i)/r*2-1,y:-(n.clientY-t.top-s)/o*2+1,button:n.button}}}function XT(n){if(this.enabled)switch(n.pointerType){case"mouse":case"pen":this.pointerHover(this._getPointer(n));break}}function $T(n){this.enabled&&(document.pointerLockElement||this.domElement.setPointerCapture(n.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.pointerHover(this._getPointer(n)),this.pointerDown(this._getPointer(n)))}function YT(n){this.enabled&&this.pointerMove(this._getPointer(n))}function qT(n){this.enabled&&(this.domElement.releasePointerCapture(n.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.pointerUp(this._getPointer(n)))}function Wf(n,t,e){let i=t.intersectObject(n,!0);for(let s=0;s<i.length;s++)if(i[s].object.visible||e)return i[s];return!1}var lu=new Oi,He=new R(0,1,0),Z_=new R(0,0,0),j_=new Kt,cu=new Ie,uu=new Ie,ws=new R,fu=new Kt,Rl=new R(1,0,0),eo=new R(0,1,0),Pl=new R(0,0,1),hu=new R,Tl=new R,Cl=new R,Xf=class extends un{constructor(t){super(),this.isTransformControlsRoot=!0,this.controls=t,this.visible=!1}updateMatrixWorld(t){let e=this.controls;e.object!==void 0&&(e.object.updateMatrixWorld(),e.object.parent===null?console.error("TransformControls: The attached 3D object must be a part of the scene graph."):e.object.parent.matrixWorld.decompose(e._parentPosition,e._parentQuaternion,e._parentScale),e.object.matrixWorld.decompose(e.worldPosition,e.worldQuaternion,e._worldScale),e._parentQuaternionInv.copy(e._parentQuaternion).invert(),e._worldQuaternionInv.copy(e.worldQuaternion).invert()),e.camera.updateMatrixWorld(),e.camera.matrixWorld.decompose(e.cameraPosition,e.cameraQuaternion,e._cameraScale),e.camera.isOrthographicCamera?e.camera.getWorldDirection(e.eye).negate():e.eye.copy(e.cameraPosition).sub(e.worldPosition).normalize(),this.parent&&(fu.copy(this.parent.matrixWorld).invert(),fu.decompose(this.position,this.quaternion,this.scale)),super.updateMatrixWorld(t)}dispose(){this.traverse(function(t){t.geometry&&t.geometry.dispose(),t.material&&t.material.dispose()})}},$f=class extends un{constructor(){super(),this.isTransformControlsGizmo=!0,this.type="TransformControlsGizmo";let t=new oi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),e=new Fi({depthTest:!1,depthWrite:!1,fog:!1,toneMapped:!1,transparent:!0}),i=t.clone();i.opacity=.15;let s=e.clone();s.opacity=.5;let r=t.clone();r.color.setHex(16711680);let o=t.clone();o.color.setHex(65280);let a=t.clone();a.color.setHex(255);let l=t.clone();l.color.setHex(16711680),l.opacity=.5;let c=t.clone();c.color.setHex(65280),c.opacity=.5;let h=t.clone();h.color.setHex(255),h.opacity=.5;let d=t.clone();d.opacity=.25;let u=t.clone();u.color.setHex(16776960),u.opacity=.25;let f=t.clone();f.color.setHex(16776960);let p=t.clone();p.color.setHex(7895160),this.materialLib={xAxis:r,yAxis:o,zAxis:a,active:f,xAxisTransparent:l,yAxisTransparent:c,zAxisTransparent:h,activeTransparent:u};let _=new Ge(0,.04,.1,12);_.translate(0,.05,0);let m=new Ye(.08,.08,.08);m.translate(0,.04,0);let g=new Me;g.setAttribute("position",new ie([0,0,0,1,0,0],3));let x=new Ge(.0075,.0075,.5,3);x.translate(0,.25,0);function b(G,q){let V=new Ai(G,.0075,3,64,q*Math.PI*2);return V.rotateY(Math.PI/2),V.rotateX(Math.PI/2),V}function v(){let G=new Me;return G.setAttribute("position",new ie([0,0,0,1,1,1],3)),G}let C={X:[[new mt(_,r),[.5,0,0],[0,0,-Math.PI/2]],[new mt(_,r),[-.5,0,0],[0,0,Math.PI/2]],[new mt(x,r),[0,0,0],[0,0,-Math.PI/2]]],Y:[[new mt(_,o),[0,.5,0]],[new mt(_,o),[0,-.5,0],[Math.PI,0,0]],[new mt(x,o)]],Z:[[new mt(_,a),[0,0,.5],[Math.PI/2,0,0]],[new mt(_,a),[0,0,-.5],[-Math.PI/2,0,0]],[new mt(x,a),null,[Math.PI/2,0,0]]],XYZ:[[new mt(new fr(.1,0),d),[0,0,0]]],XY:[[new mt(new Ye(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new mt(new Ye(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new Ye(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]]},E={X:[[new mt(new Ge(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new mt(new Ge(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new mt(new Ge(.2,0,.6,4),i),[0,.3,0]],[new mt(new Ge(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new mt(new Ge(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new mt(new Ge(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XYZ:[[new mt(new fr(.2,0),i)]],XY:[[new mt(new Ye(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new mt(new Ye(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new Ye(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]]},y={START:[[new mt(new fr(.01,2),s),null,null,null,"helper"]],END:[[new mt(new fr(.01,2),s),null,null,null,"helper"]],DELTA:[[new Ei(v(),s),null,null,null,"helper"]],X:[[new Ei(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new Ei(g,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new Ei(g,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]},w={XYZE:[[new mt(b(.5,1),p),null,[0,Math.PI/2,0]]],X:[[new mt(b(.5,.5),r)]],Y:[[new mt(b(.5,.5),o),null,[0,0,-Math.PI/2]]],Z:[[new mt(b(.5,.5),a),null,[0,Math.PI/2,0]]],E:[[new mt(b(.75,1),u),null,[0,Math.PI/2,0]]]},I={AXIS:[[new Ei(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]]},P={XYZE:[[new mt(new ui(.25,10,8),i)]],X:[[new mt(new Ai(.5,.1,4,24),i),[0,0,0],[0,-Math.PI/2,-Math.PI/2]]],Y:[[new mt(new Ai(.5,.1,4,24),i),[0,0,0],[Math.PI/2,0,0]]],Z:[[new mt(new Ai(.5,.1,4,24),i),[0,0,0],[0,0,-Math.PI/2]]],E:[[new mt(new Ai(.75,.1,2,24),i)]]},D={X:[[new mt(m,r),[.5,0,0],[0,0,-Math.PI/2]],[new mt(x,r),[0,0,0],[0,0,-Math.PI/2]],[new mt(m,r),[-.5,0,0],[0,0,Math.PI/2]]],Y:[[new mt(m,o),[0,.5,0]],[new mt(x,o)],[new mt(m,o),[0,-.5,0],[0,0,Math.PI]]],Z:[[new mt(m,a),[0,0,.5],[Math.PI/2,0,0]],[new mt(x,a),[0,0,0],[Math.PI/2,0,0]],[new mt(m,a),[0,0,-.5],[-Math.PI/2,0,0]]],XY:[[new mt(new Ye(.15,.15,.01),h),[.15,.15,0]]],YZ:[[new mt(new Ye(.15,.15,.01),l),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new Ye(.15,.15,.01),c),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new mt(new Ye(.1,.1,.1),d)]]},F={X:[[new mt(new Ge(.2,0,.6,4),i),[.3,0,0],[0,0,-Math.PI/2]],[new mt(new Ge(.2,0,.6,4),i),[-.3,0,0],[0,0,Math.PI/2]]],Y:[[new mt(new Ge(.2,0,.6,4),i),[0,.3,0]],[new mt(new Ge(.2,0,.6,4),i),[0,-.3,0],[0,0,Math.PI]]],Z:[[new mt(new Ge(.2,0,.6,4),i),[0,0,.3],[Math.PI/2,0,0]],[new mt(new Ge(.2,0,.6,4),i),[0,0,-.3],[-Math.PI/2,0,0]]],XY:[[new mt(new Ye(.2,.2,.01),i),[.15,.15,0]]],YZ:[[new mt(new Ye(.2,.2,.01),i),[0,.15,.15],[0,Math.PI/2,0]]],XZ:[[new mt(new Ye(.2,.2,.01),i),[.15,0,.15],[-Math.PI/2,0,0]]],XYZ:[[new mt(new Ye(.2,.2,.2),i),[0,0,0]]]},z={X:[[new Ei(g,s),[-1e3,0,0],null,[1e6,1,1],"helper"]],Y:[[new Ei(g,s),[0,-1e3,0],[0,0,Math.PI/2],[1e6,1,1],"helper"]],Z:[[new Ei(g,s),[0,0,-1e3],[0,-Math.PI/2,0],[1e6,1,1],"helper"]]};function O(G){let q=new un;for(let V in G)for(let ot=G[V].length;ot--;){let $=G[V][ot][0].clone(),K=G[V][ot][1],et=G[V][ot][2],ht=G[V][ot][3],ut=G[V][ot][4];$.name=V,$.tag=ut,K&&$.position.set(K[0],K[1],K[2]),et&&$.rotation.set(et[0],et[1],et[2]),ht&&$.scale.set(ht[0],ht[1],ht[2]),$.updateMatrix();let Q=$.geometry.clone();Q.applyMatrix4($.matrix),$.geometry=Q,$.renderOrder=1/0,$.position.set(0,0,0),$.rotation.set(0,0,0),$.scale.set(1,1,1),q.add($)}return q}this.gizmo={},this.picker={},this.helper={},this.add(this.gizmo.translate=O(C)),this.add(this.gizmo.rotate=O(w)),this.add(this.gizmo.scale=O(D)),this.add(this.picker.translate=O(E)),this.add(this.picker.rotate=O(P)),this.add(this.picker.scale=O(F)),this.add(this.helper.translate=O(y)),this.add(this.helper.rotate=O(I)),this.add(this.helper.scale=O(z)),this.picker.translate.visible=!1,this.picker.rotate.visible=!1,this.picker.scale.visible=!1}updateMatrixWorld(t){let i=(this.mode==="scale"?"local":this.space)==="local"?this.worldQuaternion:uu;this.gizmo.translate.visible=this.mode==="translate",this.gizmo.rotate.visible=this.mode==="rotate",this.gizmo.scale.visible=this.mode==="scale",this.helper.translate.visible=this.mode==="translate",this.helper.rotate.visible=this.mode==="rotate",this.helper.scale.visible=this.mode==="scale";let s=[];s=s.concat(this.picker[this.mode].children),s=s.concat(this.gizmo[this.mode].children),s=s.concat(this.helper[this.mode].children);for(let r=0;r<s.length;r++){let o=s[r];o.visible=!0,o.rotation.set(0,0,0),o.position.copy(this.worldPosition);let a;if(this.camera.isOrthographicCamera?a=(this.camera.top-this.camera.bottom)/this.camera.zoom:a=this.worldPosition.distanceTo(this.cameraPosition)*Math.min(1.9*Math.tan(Math.PI*this.camera.fov/360)/this.camera.zoom,7),o.scale.set(1,1,1).multiplyScalar(a*this.size/4),o.tag==="helper"){o.visible=!1,o.name==="AXIS"?(o.visible=!!this.axis,this.axis==="X"&&(an.setFromEuler(lu.set(0,0,0)),o.quaternion.copy(i).multiply(an),Math.abs(He.copy(Rl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Y"&&(an.setFromEuler(lu.set(0,0,Math.PI/2)),o.quaternion.copy(i).multiply(an),Math.abs(He.copy(eo).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="Z"&&(an.setFromEuler(lu.set(0,Math.PI/2,0)),o.quaternion.copy(i).multiply(an),Math.abs(He.copy(Pl).applyQuaternion(i).dot(this.eye))>.9&&(o.visible=!1)),this.axis==="XYZE"&&(an.setFromEuler(lu.set(0,Math.PI/2,0)),He.copy(this.rotationAxis),o.quaternion.setFromRotationMatrix(j_.lookAt(Z_,He,eo)),o.quaternion.multiply(an),o.visible=this.dragging),this.axis==="E"&&(o.visible=!1)):o.name==="START"?(o.position.copy(this.worldPositionStart),o.visible=this.dragging):o.name==="END"?(o.position.copy(this.worldPosition),o.visible=this.dragging):o.name==="DELTA"?(o.position.copy(this.worldPositionStart),o.quaternion.copy(this.worldQuaternionStart),_n.set(1e-10,1e-10,1e-10).add(this.worldPositionStart).sub(this.worldPosition).multiplyScalar(-1),_n.applyQuaternion(this.worldQuaternionStart.clone().invert()),o.scale.copy(_n),o.visible=this.dragging):(o.quaternion.copy(i),this.dragging?o.position.copy(this.worldPositionStart):o.position.copy(this.worldPosition),this.axis&&(o.visible=this.axis.search(o.name)!==-1));continue}o.quaternion.copy(i),this.mode==="translate"||this.mode==="scale"?(o.name==="X"&&Math.abs(He.copy(Rl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Y"&&Math.abs(He.copy(eo).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="Z"&&Math.abs(He.copy(Pl).applyQuaternion(i).dot(this.eye))>.99&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XY"&&Math.abs(He.copy(Pl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="YZ"&&Math.abs(He.copy(Rl).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1),o.name==="XZ"&&Math.abs(He.copy(eo).applyQuaternion(i).dot(this.eye))<.2&&(o.scale.set(1e-10,1e-10,1e-10),o.visible=!1)):this.mode==="rotate"&&(cu.copy(i),He.copy(this.eye).applyQuaternion(an.copy(i).invert()),o.name.search("E")!==-1&&o.quaternion.setFromRotationMatrix(j_.lookAt(this.eye,Z_,eo)),o.name==="X"&&(an.setFromAxisAngle(Rl,Math.atan2(-He.y,He.z)),an.multiplyQuaternions(cu,an),o.quaternion.copy(an)),o.name==="Y"&&(an.setFromAxisAngle(eo,Math.atan2(He.x,He.z)),an.multiplyQuaternions(cu,an),o.quaternion.copy(an)),o.name==="Z"&&(an.setFromAxisAngle(Pl,Math.atan2(He.y,He.x)),an.multiplyQuaternions(cu,an),o.quaternion.copy(an))),o.visible=o.visible&&(o.name.indexOf("X")===-1||this.showX),o.visible=o.visible&&(o.name.indexOf("Y")===-1||this.showY),o.visible=o.visible&&(o.name.indexOf("Z")===-1||this.showZ),o.visible=o.visible&&(o.name.indexOf("E")===-1||this.showX&&this.showY&&this.showZ),o.visible=o.visible&&(o.name.indexOf("XY")===-1||this.showXY),o.visible=o.visible&&(o.name.indexOf("YZ")===-1||this.showYZ),o.visible=o.visible&&(o.name.indexOf("XZ")===-1||this.showXZ),o.visible=o.visible&&(o.name!=="E"||this.showE),o.visible=o.visible&&(o.name!=="XYZE"||this.showXYZE),o.material._color=o.material._color||o.material.color.clone(),o.material._opacity=o.material._opacity||o.material.opacity,o.material.color.copy(o.material._color),o.material.opacity=o.material._opacity,this.enabled&&this.axis&&(o.name===this.axis?(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1):this.axis.split("").some(function(l){return o.name===l})&&(o.material.color.copy(this.materialLib.active.color),o.material.opacity=1))}super.updateMatrixWorld(t)}},Yf=class extends mt{constructor(){super(new Hr(1e5,1e5,2,2),new oi({visible:!1,wireframe:!0,side:on,transparent:!0,opacity:.1,toneMapped:!1})),this.isTransformControlsPlane=!0,this.type="TransformControlsPlane"}updateMatrixWorld(t){let e=this.space;switch(this.position.copy(this.worldPosition),this.mode==="scale"&&(e="local"),hu.copy(Rl).applyQuaternion(e==="local"?this.worldQuaternion:uu),Tl.copy(eo).applyQuaternion(e==="local"?this.worldQuaternion:uu),Cl.copy(Pl).applyQuaternion(e==="local"?this.worldQuaternion:uu),He.copy(Tl),this.mode){case"translate":case"scale":switch(this.axis){case"X":He.copy(this.eye).cross(hu),ws.copy(hu).cross(He);break;case"Y":He.copy(this.eye).cross(Tl),ws.copy(Tl).cross(He);break;case"Z":He.copy(this.eye).cross(Cl),ws.copy(Cl).cross(He);break;case"XY":ws.copy(Cl);break;case"YZ":ws.copy(hu);break;case"XZ":He.copy(Cl),ws.copy(Tl);break;case"XYZ":case"E":ws.set(0,0,0);break}break;default:ws.set(0,0,0)}ws.length()===0?this.quaternion.copy(this.cameraQuaternion):(fu.lookAt(_n.set(0,0,0),ws,He),this.quaternion.setFromRotationMatrix(fu)),super.updateMatrixWorld(t)}};var ZT=["#d55e00","#009e73","#0072b2","#e69f00"],jT=["E","XYZE","XYZ","XY","YZ","XZ"],J_={move:.01,turn:Math.PI/12},qf=({position:n,quaternion:{x:t,y:e,z:i,w:s}})=>({position:n.toArray(),rotation:[s,t,e,i]});function JT(n,{position:t,rotation:[e,i,s,r]}){n.position.set(...t),n.quaternion.set(i,s,r,e).normalize(),n.updateMatrixWorld()}function K_(n,t){let e=new un;n.scene.add(e);let i=null,s=new Kt,r=(m,g)=>{let x=new du(n.camera,n.canvas);x.setMode(m),x.setSpace(m==="rotate"?"local":"world"),x.setSize(g),x.addEventListener("change",n.draw),x.addEventListener("dragging-changed",({value:v})=>{n.controls.enabled=!v}),x.addEventListener("objectChange",()=>t(qf(e))),x.setColors(...ZT);let b=[];x.getHelper().traverse(v=>jT.includes(v.name)&&b.push(v));for(let v of b)v.removeFromParent();return n.scene.add(x.getHelper()),x},o=r("translate",.75),a=r("rotate",.95);o.addEventListener("axis-changed",({value:m})=>{o.dragging||(a.enabled=i!==null&&m===null)});let l=[o,a],c=m=>{o.setTranslationSnap(m?J_.move:null),a.setRotationSnap(m?J_.turn:null)};for(let m of["keydown","keyup"])addEventListener(m,({key:g})=>g==="Shift"&&c(m==="keydown"));let h=()=>l.some(m=>m.dragging),d=()=>{i=null;for(let m of l)m.detach(),m.enabled=!1;n.draw()},u=(m,g)=>{i=g,JT(e,m),s=i.matrixWorld.clone().invert().multiply(e.matrixWorld);for(let x of l)x.enabled=!0,x.attach(e);n.draw()},f=()=>{if(!i||h())return;i.matrixWorld.clone().multiply(s).decompose(e.position,e.quaternion,new R)},p=({by:m,about:g,angle:x})=>{if(!i)return null;m&&e.position.add(new R(...m)),g&&e.quaternion.premultiply(new Ie().setFromAxisAngle(new R(...g),x)),e.updateMatrixWorld();let b=qf(e);return t(b),b};return d(),{show:u,hide:d,goAlong:f,nudge:p,busy:()=>l.some(m=>m.enabled&&m.axis!==null),dragging:h,pose:()=>qf(e),shown:()=>i!==null}}var KT=5;function Q_(n,t,{joint:e,place:i},s){let r=new $r,o=u=>{let{x:f,y:p}=n.ray(u);return r.setFromCamera(new $t(f,p),n.camera),r},a=null,l=null,c=u=>{u.button===0&&(a={x:u.clientX,y:u.clientY},l=i.busy()?null:e.grab(o(u)),l&&(n.controls.enabled=!1,n.canvas.setPointerCapture(u.pointerId),n.canvas.classList.add("holding"),u.stopImmediatePropagation(),n.canvas.focus({preventScroll:!0})))},h=()=>{l&&(n.controls.enabled=!0),l=null,n.canvas.classList.remove("holding")},d=u=>{let f=a&&Math.hypot(u.clientX-a.x,u.clientY-a.y)<KT&&!l,p=i.dragging()||i.busy();if(a=null,h(),f&&!p&&u.type==="pointerup"){let[_]=o(u).intersectObjects(t.meshes(),!1);s(_?_.object.userData.body:-1)}};return n.canvas.addEventListener("pointerdown",c,{capture:!0}),n.canvas.addEventListener("pointermove",u=>l?.(o(u))),n.canvas.addEventListener("pointerup",d,{capture:!0}),n.canvas.addEventListener("pointercancel",d),n.canvas.addEventListener("pointerdown",()=>n.canvas.focus({preventScroll:!0})),{dragging:()=>l!==null}}var tx={type:"change"},jf={type:"start"},nx={type:"end"},pu=new ur,ex=new Si,QT=Math.cos(70*ta.DEG2RAD),Ln=new R,fi=2*Math.PI,Ce={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Zf=1e-6,ca=class extends Yr{constructor(t,e=null){super(t,e),this.state=Ce.NONE,this.target=new R,this.cursor=new R,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:xr.ROTATE,MIDDLE:xr.DOLLY,RIGHT:xr.PAN},this.touches={ONE:yr.ROTATE,TWO:yr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new R,this._lastQuaternion=new Ie,this._lastTargetPosition=new R,this._quat=new Ie().setFromUnitVectors(t.up,new R(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Zo,this._sphericalDelta=new Zo,this._scale=1,this._panOffset=new R,this._rotateStart=new $t,this._rotateEnd=new $t,this._rotateDelta=new $t,this._panStart=new $t,this._panEnd=new $t,this._panDelta=new $t,this._dollyStart=new $t,this._dollyEnd=new $t,this._dollyDelta=new $t,this._dollyDirection=new R,this._mouse=new $t,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=eC.bind(this),this._onPointerDown=tC.bind(this),this._onPointerUp=nC.bind(this),this._onContextMenu=cC.bind(this),this._onMouseWheel=rC.bind(this),this._onKeyDown=oC.bind(this),this._onTouchStart=aC.bind(this),this._onTouchMove=lC.bind(this),this._onMouseDown=iC.bind(this),this._onMouseMove=sC.bind(this),this._interceptControlDown=hC.bind(this),this._interceptControlUp=uC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ce.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(tx),this.update(),this.state=Ce.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Ln.copy(e).sub(this.target),Ln.applyQuaternion(this._quat),this._spherical.setFromVector3(Ln),this.autoRotate&&this.state===Ce.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=fi:i>Math.PI&&(i-=fi),s<-Math.PI?s+=fi:s>Math.PI&&(s-=fi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ln.setFromSpherical(this._spherical),Ln.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ln),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ln.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new R(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new R(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ln.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(pu.origin.copy(this.object.position),pu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(pu.direction))<QT?this.object.lookAt(this.target):(ex.setFromNormalAndCoplanarPoint(this.object.up,this.target),pu.intersectPlane(ex,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Zf||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Zf||this._lastTargetPosition.distanceToSquared(this.target)>Zf?(this.dispatchEvent(tx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?fi/60*this.autoRotateSpeed*t:fi/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ln.setFromMatrixColumn(e,0),Ln.multiplyScalar(-t),this._panOffset.add(Ln)}_panUp(t,e){this.screenSpacePanning===!0?Ln.setFromMatrixColumn(e,1):(Ln.setFromMatrixColumn(e,0),Ln.crossVectors(this.object.up,Ln)),Ln.multiplyScalar(t),this._panOffset.add(Ln)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ln.copy(s).sub(this.target);let r=Ln.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(fi*this._rotateDelta.x/e.clientHeight),this._rotateUp(fi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(fi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-fi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(fi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-fi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(fi*this._rotateDelta.x/e.clientHeight),this._rotateUp(fi*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new $t,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function tC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function eC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function nC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(nx),this.state=Ce.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function iC(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case xr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ce.DOLLY;break;case xr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}break;case xr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(jf)}function sC(n){switch(this.state){case Ce.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ce.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ce.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function rC(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ce.NONE||(n.preventDefault(),this.dispatchEvent(jf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(nx))}function oC(n){this.enabled!==!1&&this._handleKeyDown(n)}function aC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case yr.ROTATE:if(this.enableRotate===!1){this.state=Ce.NONE;break}this._handleTouchStartRotate(n),this.state=Ce.TOUCH_ROTATE;break;case yr.PAN:if(this.enablePan===!1){this.state=Ce.NONE;break}this._handleTouchStartPan(n),this.state=Ce.TOUCH_PAN;break;default:this.state=Ce.NONE}break;case 2:switch(this.touches.TWO){case yr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ce.TOUCH_DOLLY_PAN;break;case yr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ce.TOUCH_DOLLY_ROTATE;break;default:this.state=Ce.NONE}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(jf)}function lC(n){switch(this._trackPointer(n),this.state){case Ce.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ce.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ce.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ce.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ce.NONE}}function cC(n){this.enabled!==!1&&n.preventDefault()}function hC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function uC(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var ix=1.12;function Il(n){let t=Math.abs(n.x)<.9?new R(1,0,0):new R(0,1,0);return t.addScaledVector(n,-t.dot(n)).normalize(),new R().crossVectors(t,n).multiplyScalar(1).addScaledVector(t,.7).addScaledVector(n,.6).normalize()}function mu(n){let t=new Xr(-1,1,1,-1,.1,10);return t.up.copy(n),t}var dC=({min:n,max:t})=>[0,1,2,3,4,5,6,7].map(e=>new R(e&1?t.x:n.x,e&2?t.y:n.y,e&4?t.z:n.z));function fC(n,t,e){let i=new R,s=new R;n.matrixWorld.extractBasis(i,s,new R);let r=o=>Math.max(...dC(t).map(a=>Math.abs(a.sub(e).dot(o))));return{x:r(i),y:r(s)}}function ha(n,t){let e=n.userData.half??{x:1,y:1},i=Math.max(e.y,e.x/t);Object.assign(n,{left:-i*t,right:i*t,top:i,bottom:-i}),n.updateProjectionMatrix()}function Ll(n,t,e,i){let s=t.isEmpty()?new tn(new R(-1,-1,-1),new R(1,1,1)):t,r=s.getCenter(new R),o=s.getSize(new R).length()/2||1;n.position.copy(r).addScaledVector(i??Il(n.up),4*o),n.near=.01*o,n.far=20*o,n.zoom=1,n.lookAt(r),n.updateMatrixWorld();let a=fC(n,s,r);return n.userData.half={x:ix*a.x,y:ix*a.y},ha(n,e),r}var pC=new R(0,1,0);function gu(n,t,e){let i=Er(t/12),s=2*Math.ceil(.6*t/i),r=new ll(s*i,s,"#888888","#888888");r.material.transparent=!0,r.material.opacity=.28,r.quaternion.setFromUnitVectors(pC,e);let o=n.isEmpty()?new R:n.getCenter(new R),a=n.isEmpty()?0:n.getSize(new R).multiply(new R(...e.toArray().map(Math.abs))).length()/2;return r.position.copy(o).addScaledVector(e,-a),{grid:r,step:i}}var Jf=1024;function mC(n,{up:t,from:e,center:i,radius:s}){let r=new Yo(16777215,1.9),o=new R().crossVectors(t,e),a=e.clone().addScaledVector(t,1.3).addScaledVector(o,-.8).normalize();r.position.copy(i).addScaledVector(a,2*s),r.target.position.copy(i),r.castShadow=!0,r.shadow.mapSize.set(Jf,Jf);let l={left:-s,right:s,top:s,bottom:-s};Object.assign(r.shadow.camera,l,{near:.2*s,far:4*s}),r.shadow.normalBias=4*s/Jf,r.shadow.radius=4,n.add(r,r.target)}function _u(n,t,e,i){let s=new sl(16777215,9080729,i?1.3:1.6);s.position.copy(e);let r=new Yo(16777215,i?.7:1.8);r.position.set(-.6,.8,1),t.add(r),n.add(s,t),i&&mC(n,{...i,up:e})}var gC=[0,-1,1,-2,2,-3,3,-4,4],_C=(n,t)=>n.left<t.right&&t.left<n.right&&n.top<t.bottom&&t.top<n.bottom;function xC({x:n,y:t,width:e}){return gC.flatMap(i=>[n+6,n-6-e].map(s=>({left:s,right:s+e,top:t+(i-.5)*14,bottom:t+(i+.5)*14,far:i!==0})))}function sx(n,{width:t,height:e},i=[]){let s=[...i],r=({left:o,right:a,top:l,bottom:c})=>o>=2&&a<=t-2&&l>=1&&c<=e-1;return[...n].sort((o,a)=>o.depth-a.depth).flatMap(o=>{let a=xC(o).find(l=>r(l)&&!s.some(c=>_C(l,c)));return a?(s.push(a),[{label:o,place:a}]):[]})}var Kf="system-ui, sans-serif",yC=[["x","#d55e00",new R(1,0,0)],["y","#009e73",new R(0,1,0)],["z","#0072b2",new R(0,0,1)]];function Qf(n,t,e,i,s,r){n.lineJoin="round",n.lineWidth=3.5,n.strokeStyle=r,n.strokeText(t,e,i),n.fillStyle=s,n.fillText(t,e,i)}function vC(n,t,e,i){let s=n.clone().project(t);return[(s.x+1)/2*e,(1-s.y)/2*i]}var SC=({width:n,height:t,compact:e})=>[{left:n-110,right:n,top:t-36,bottom:t},...e?[]:[{left:0,right:84,top:t-84,bottom:t}]];function xu(n,t,e,i,s=[]){let{width:r,height:o,ink:a,page:l,muted:c}=i;n.font=`600 12px ${Kf}`,n.textBaseline="middle";let h=t.map(({position:u,text:f})=>{let p=u.clone().project(e),[_,m]=vC(u,e,r,o);return{x:_,y:m,depth:p.z,text:f,width:n.measureText(f).width}}),d=sx(h,i,[...SC(i),...s]);n.strokeStyle=c??a,n.lineWidth=1;for(let{label:u,place:f}of d.filter(p=>p.place.far))n.beginPath(),n.moveTo(u.x,u.y),n.lineTo(f.left>u.x?f.left-2:f.right+2,(f.top+f.bottom)/2),n.stroke();for(let{label:u,place:f}of d)Qf(n,u.text,f.left,(f.top+f.bottom)/2,a,l)}function yu(n,t,e,{width:i,height:s,ink:r,page:o}){let a=i*t.zoom/(t.right-t.left),l=Er(50/a),c=i-16,h=s-14;n.strokeStyle=r,n.lineWidth=2,n.beginPath();let d=c-l*a;n.moveTo(d,h-4),n.lineTo(d,h),n.lineTo(c,h),n.lineTo(c,h-4),n.stroke(),n.font=`12px ${Kf}`,n.textAlign="center",Qf(n,`${pe(l)} ${e}`,(d+c)/2,h-10,r,o),n.textAlign="left"}function bC(n,t){let e=n.dot(t);return e>.999?" up":e<-.999?" down":""}function vu(n,t,{height:e,ink:i,page:s}){let r=[42,e-40],o=24,a=yC.map(([l,c,h])=>({name:l+bC(h,t.up),color:c,v:h.clone().transformDirection(t.matrixWorldInverse)}));n.font=`600 11px ${Kf}`,n.textAlign="center",n.textBaseline="middle";for(let{name:l,color:c,v:h}of a.sort((d,u)=>d.v.z-u.v.z)){n.strokeStyle=c,n.lineWidth=2.5,n.beginPath(),n.moveTo(...r),n.lineTo(r[0]+o*h.x,r[1]-o*h.y),n.stroke();let d=o+9;Qf(n,l,r[0]+d*h.x,r[1]-d*h.y,i,s)}n.textAlign="left"}function tp(n){let{camera:t,width:e,height:i,insets:s}=n,r={width:Math.max(80,e-s.left-s.right),height:Math.max(80,i-s.top-s.bottom)};ha(t,r.width/r.height);let[o,a]=[e/r.width,i/r.height];t.left*=o,t.right*=o,t.top*=a,t.bottom*=a;let l={x:(s.right-s.left)/2,y:(s.bottom-s.top)/2};t.setViewOffset(e,i,l.x,l.y,e,i)}function rx(n){let{camera:t,canvas:e,controls:i}=n;n.aim=()=>tp(n),n.fit=(s=n.from)=>{n.from=s.clone().normalize(),i.target.copy(Ll(t,n.box,1,n.from));let r=n.box.getSize(new R).length();t.position.copy(i.target).addScaledVector(n.from,20*r),t.near=r,t.far=60*r,tp(n),i.update(),n.draw()},n.setInsets=s=>{n.insets={...n.insets,...s},tp(n),n.draw()},n.ray=({clientX:s,clientY:r})=>{let o=e.getBoundingClientRect(),a=2*(s-o.left)/o.width-1,l=1-2*(r-o.top)/o.height;return{x:a,y:l}},n.pixel=s=>{let r=s.clone().project(t),o=e.getBoundingClientRect();return{x:o.left+(r.x+1)/2*o.width,y:o.top+(1-r.y)/2*o.height}}}var Su=new R(0,0,1),ox=new tn(new R(-.15,-.15,0),new R(.15,.15,.15)),wC=45,MC=.6,EC=250;function AC(n){let t=new na({canvas:n,antialias:!0,alpha:!0});return t.setPixelRatio(1),t.shadowMap.enabled=!0,t.shadowMap.type=Hs,t.shadowMap.autoUpdate=!1,t}function TC(n){let t=n.getContext(),e=t.getExtension("WEBGL_debug_renderer_info"),i=t.getParameter(e?e.UNMASKED_RENDERER_WEBGL:t.RENDERER);return/swiftshader|llvmpipe|software|basic render/i.test(String(i))}function CC(n,t){n.furniture.removeFromParent(),n.camera.clear(),n.sun?.dispose(),n.grid?.dispose();let e=t.getSize(new R).length()||1;n.furniture=new Te;let{grid:i}=gu(t,e,Su);i.visible=n.shown.grid,n.grid=i;let s=t.getCenter(new R),r={from:n.from,center:s,radius:.75*e},o=new Te;_u(o,n.camera,Su,r),n.sun=o.children.find(({castShadow:a})=>a),n.furniture.add(i,o),n.scene.add(n.furniture)}function RC(n,t,e){let{width:i,height:s,insets:r}=n,o=n.ratio;t.setTransform(o,0,0,o,0,0),t.clearRect(0,0,i,s);let a={...e(),width:i,height:s};xu(t,n.labels(),n.camera,a,n.covered()),t.translate(r.left,-r.bottom),vu(t,n.camera,a);let{left:l,right:c,zoom:h}=n.camera;t.translate(-r.left-r.right,0),yu(t,{left:1e3*l,right:1e3*c,zoom:h},"mm",a)}function PC(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function IC(n,t){let{canvas:e,words:i,renderer:s,scene:r,camera:o}=n,a=TC(s),l=null,c=h=>{let[d,u]=[n.width,n.height].map(f=>Math.max(1,Math.round(f*n.ratio*h)));(e.width!==d||e.height!==u)&&s.setSize(d,u,!1)};n.paintNow=(h=!(a||n.cost>wC))=>{let d=performance.now();c(h?1:MC);let u=n.shown.shadows&&h;s.shadowMap.needsUpdate=u,n.sun.castShadow=u;for(let f of n.preparing)f();s.render(r,o),RC(n,i.getContext("2d"),t),h&&(n.cost=.5*n.cost+.5*(performance.now()-d)),++n.paints;for(let f of n.painted)f();clearTimeout(l),h||(l=setTimeout(()=>n.paintNow(!0),EC))},n.draw=PC(()=>n.paintNow())}function ax(n,t){let e=document.createElement("canvas");e.className="gl",e.tabIndex=0;let i=document.createElement("canvas");i.className="words",i.setAttribute("aria-hidden","true"),n.append(e,i);let s=AC(e),r=new Gr,o=mu(Su),a={canvas:e,words:i,renderer:s,scene:r,camera:o,width:1,height:1,ratio:1,insets:{left:0,right:0,top:0,bottom:0},furniture:new Te,shown:{grid:!0,shadows:!0},from:Il(Su),box:ox.clone(),labels:()=>[],covered:()=>[],preparing:[],painted:[],paints:0,cost:0};IC(a,t);let l=new ca(o,e);l.enableDamping=!1,l.addEventListener("change",a.draw),a.controls=l,a.look=h=>{a.box=h.isEmpty()?ox.clone():h,CC(a,a.box),a.draw()},a.picture=()=>{a.paintNow(!0);let h=document.createElement("canvas");h.width=i.width,h.height=i.height;let d=h.getContext("2d");return d.fillStyle=t().page,d.fillRect(0,0,h.width,h.height),d.drawImage(e,0,0,h.width,h.height),d.drawImage(i,0,0),h};let c=()=>{a.width=Math.max(1,n.clientWidth),a.height=Math.max(1,n.clientHeight),a.ratio=Math.min(2,devicePixelRatio),i.width=Math.round(a.width*a.ratio),i.height=Math.round(a.height*a.ratio),a.aim(),a.paintNow()};return rx(a),a.look(new tn),a.fit(),new ResizeObserver(c).observe(n),c(),a}var LC=(n,t)=>!n||n.mode!==t.mode||n.bodies.length===0||!t.bodies.some(({owner:e})=>n.bodies.some(i=>i.owner===e)),DC=({eye:n,target:t})=>new R(...n).sub(new R(...t));async function NC(n){let t=await fetch(`/mesh/${n}${location.search}`);if(!t.ok)throw new Error(`mesh ${n}: ${t.status} ${t.statusText}`);return t.arrayBuffer()}function lx(n,t,e){let i=ax(n,t),s=x_(NC),r=y_(i.scene,s,i.draw),o=H_(i.scene),a=T_(i.scene),l=C_(i.scene),c=S_(i.scene),h=W_(i.scene,i.draw),d=U_(i,e.moveJoint),u=K_(i,e.place),f=Q_(i,r,{joint:d,place:u},e.select);i.preparing.push(()=>o.sharpen(i.canvas.width/i.width));let p=null,_=null,m=!1,g=!1,x=[],b=()=>i.box.getSize(new R).length()||1;function v(){!_||!g||(i.look(r.box()),m&&i.fit(DC(p)),m=!1,C(_))}function C(w){_&&w.bodies.some((F,z)=>F!==_.bodies[z])&&h.clear(),_=w,r.pose(_),u.goAlong();let I=o.pose(_),{forceScale:P}=a.pose(_,b());x=l.pose(_,b());let{held:D}=d;D()&&d.tell(_.joints[p.joints.indexOf(D().joint)]),e.changed({tensionEnd:I,forceScale:P}),i.draw()}return{stage:i,bodies:r,lines:o,contacts:a,vectors:l,pads:h,joint:d,place:u,pointer:f,show:w=>{m||(m=LC(p,w)),m&&a.forget();let I=d.held()?.joint;p=w,_=null,g=!1;let P=r.show(p).then(()=>{g=p===w});o.show(p),l.show(p),c.show(p,r.groups);let D=I&&p.joints.find(({name:F,hand:z})=>F===I.name&&z===I.hand);return d.show(D??null,D&&r.groups[D.body],d.held()?.value??0),P.then(v,e.failed)},pose:w=>{if(!p||!i_(p,w))return!1;let I=_===null;return C(w),I&&m&&v(),!0},tips:()=>x,frame:()=>_,fitting:()=>m,meshCount:s.size}}var OC=()=>({ink:rn("--ink"),page:rn("--page"),muted:rn("--muted")}),UC=/^(world\.|motion\.open|motion\.record|hand\.|fit\.open)/;function FC(){let{protocol:n,host:t,search:e}=location;return`${n==="https:"?"wss:":"ws:"}//${t}/ws${e}`}function BC(n){n.call=(t,e)=>n.link.call(t,e),n.ask=async(t,e={})=>{try{let i=await n.call(t,e);return UC.test(t)&&i?.warnings?.length&&n.notices.tell(i.warnings.join(`
`)),i}catch(i){return i.code!=="lost"&&n.notices.error(`${t}: ${i.message}`),null}},n.mayLeave=async()=>!n.store.state?.world?.unsaved||Qh("The world has changes that are not saved.","Go on without them"),n.newWorld=async()=>await n.mayLeave()&&n.ask("world.new"),n.save=()=>j0(n)}function kC(n){let{store:t}=n,e=Js(({method:s,params:r})=>n.ask(s,r),eu);n.canMove=()=>Of(t.scene?.mode,{},0)!==null,n.moveJoint=(s,r)=>{let o=Of(t.scene.mode,s,r);return o?(n.wanted={joint:s,value:r},n.notices.say(d_(t.scene,s,r)),e(o).finally(()=>{n.wanted?.joint===s&&n.wanted.value===r&&(n.wanted=null)})):null};let i=Js(s=>n.ask("world.place",s));n.moveSelected=({position:s,rotation:r})=>t.selected&&i({name:t.selected.owner,position:s,rotation:r}),n.poseOf=s=>{let r=t.scene?.bodies.findIndex(o=>o.owner===s)??-1;return r<0||!t.frame?null:[...t.frame.bodies.subarray(7*r,7*r+3)]}}async function zC(n,t){let e=await n.ask("world.get");return[...e?.hands??[],...e?.bodies??[]].find(i=>i.name===t)??null}function GC(n){let{store:t}=n;n.select=async(e,{quiet:i=!1}={})=>{let{scene:s,frame:r}=t,o=e&&s?.bodies.some(({owner:u})=>u===e.owner),a=s?.joints.find(u=>u.hand===e?.owner&&u.name===e.joint),l=o||a?{owner:e.owner,joint:a?.name}:null;if(JSON.stringify(l)===JSON.stringify(t.selected))return;n.picture.bodies.select(l?.owner??null);let c=a&&r?r.joints[s.joints.indexOf(a)]:0;if(n.picture.joint.show(a??null,a&&n.picture.bodies.groups[a.body],c),n.picture.place.hide(),t.set({selected:l}),!l)return n.notices.say("nothing is selected");if(i||n.notices.say(`${l.joint??l.owner} selected`),a||s.mode!=="world")return;let h=Mr(s).find(({name:u})=>u===l.owner);if(!h.movable)return;let d=await zC(n,l.owner);d&&t.selected===l&&n.picture.place.show(d,n.picture.bodies.groups[h.bodies[0]])},n.clicked=e=>{if(e<0)return n.select(null);let{scene:i}=t,s=i.joints[r_(i,e)],{owner:r}=i.bodies[e],o=s&&t.selected?.joint===s.name&&t.selected.owner===r;return n.select({owner:r,joint:o?void 0:s?.name})},n.hide=(e,i)=>{n.picture.bodies.hide(e,i),t.set({hidden:{}}),n.picture.stage.draw()}}function VC(n){let{picture:t}=n,{stage:e}=t,i=()=>{t.frame()&&t.pose(t.frame()),e.draw()};n.view={opacity:(s,r)=>{t.bodies.opacity(s,r),e.draw()},grid:s=>{e.shown.grid=s,e.grid.visible=s,e.draw()},shadows:s=>{e.shown.shadows=s,e.draw()},names:s=>{n.names=s,e.draw()},contacts:(s,r)=>{t.contacts.show[s]=r,i()},lines:s=>{t.lines.visible(s),e.draw()},vectors:s=>{t.vectors.visible(s),e.draw()},fit:()=>{e.look(t.bodies.box()),e.fit()}},e.labels=()=>HC(n),e.covered=()=>{let{width:s,height:r,insets:o}=e;return[{left:0,right:o.left,top:0,bottom:r},{left:s-o.right,right:s,top:0,bottom:r},{left:0,right:s,top:0,bottom:o.top},{left:0,right:s,top:r-o.bottom,bottom:r}]}}function HC(n){let{scene:t}=n.store;if(!t)return[];let e=n.picture.tips().filter(({i:s})=>t.arrows[s].kind!=="axis").map(({position:s,i:r})=>({position:s,text:t.arrows[r].name})),i=n.names?n.picture.bodies.meshes().map(s=>({position:new R().setFromMatrixPosition(s.parent.matrixWorld),text:t.bodies[s.userData.body].name})):[];return[...e,...i]}function WC(n){let{store:t}=n,e=null,i=()=>{let a=e;e=null,a&&n.picture.pose(a)&&(t.set({frame:a}),!n.firstFrame&&!n.picture.fitting()&&cx(n))};n.heardFrame=a=>{let l=e!==null;e=Q0(a),n.frameAt=performance.now(),l||requestAnimationFrame(i)};let o={scene:a=>{let l=t.selected,c=n.picture.show(a);t.set({scene:a,frame:null}),l&&!a.bodies.some(({owner:d})=>d===l.owner)?n.select(null):l&&(t.selected=null,n.select(l,{quiet:!0}));let h=a.bodies.length===0;c.then(()=>(n.picture.frame()||h)&&!n.firstFrame&&cx(n))},state:a=>{t.set({state:a}),n.notices.busy(a.busy??null)},progress:n.notices.progress,ended:({reason:a})=>n.notices.error(`thenar ended: ${a??"no reason was given"}`),failed:({text:a})=>n.notices.error(a),error:({message:a})=>n.notices.error(a??"an error without words")};n.heardNotice=(a,l)=>o[a]?.(l)}function cx(n){n.firstFrame=!0,requestAnimationFrame(()=>performance.mark("thenar first picture"))}function XC(n){let t=()=>n.store.state?.world?.name||"thenar",e=null;n.savePicture=()=>F0(n.picture,t()),n.saveGltf=()=>k0(n.ask,t()),n.saveCharts=()=>{B0()||n.notices.tell("No chart is shown: plot a sweep, or let time pass.")},n.film=async()=>{if(e){let i=e;return e=null,await i(t()),!1}return e=z0(n.picture),e||n.notices.error("This browser cannot record films."),e!==null},addEventListener("beforeprint",()=>{document.querySelector(".printed")?.remove();let i=n.picture.stage.picture();i.className="printed",document.body.append(i)}),addEventListener("afterprint",()=>document.querySelector(".printed")?.remove())}function hx(n,t){let e={store:n_({link:!1,scene:null,frame:null,state:null,selected:null,hidden:{},tab:"pose"}),names:!1,wanted:null};e.notices=h_(n,()=>e.ask("session.stop")),e.legend=c_(),n.append(e.legend),e.picture=lx(t,OC,{moveJoint:(i,s)=>e.moveJoint(i,s),place:i=>e.moveSelected(i),select:i=>e.clicked(i),failed:i=>e.notices.error(i.message),changed:i=>e.legend.show(i)});for(let i of[BC,kC,GC,VC,WC,XC])i(e);return e.importFiles=Z0(e),Tm(()=>{e.picture.stage.draw(),document.querySelectorAll(".chart").forEach(i=>i.redraw?.())}),e.connect=()=>{e.link=e_(FC(),{frame:e.heardFrame,notice:e.heardNotice,link:i=>{e.notices.link(i),i.connected||e.notices.busy(null),e.store.set({link:i.connected})}})},e}function ux(n,t,e){let i=new ca(n,t);return i.enableDamping=!1,i.enableZoom=!1,t.style.touchAction="pan-y",t.addEventListener("pointerdown",()=>t.focus({preventScroll:!0})),t.addEventListener("focus",()=>{i.enableZoom=!0}),t.addEventListener("blur",()=>{i.enableZoom=!1}),i.addEventListener("change",e),i}var bu=Math.PI/24,ep=1.15;function wu(n,t,e){let i={ArrowLeft:()=>n.rotateLeft(bu),ArrowRight:()=>n.rotateLeft(-bu),ArrowUp:()=>n.rotateUp(bu),ArrowDown:()=>n.rotateUp(-bu),"+":()=>n.dollyOut(ep),"=":()=>n.dollyOut(ep),"-":()=>n.dollyIn(ep),0:e,Home:e};t.addEventListener("keydown",s=>{s.ctrlKey||s.altKey||s.metaKey||!Object.hasOwn(i,s.key)||(s.preventDefault(),i[s.key]())})}var $C={x:[1,0,0],y:[0,1,0],z:[0,0,1]},np={ArrowLeft:-1,ArrowRight:1,ArrowDown:-10,ArrowUp:10},YC=.001,qC=Math.PI/180,ZC=["pose","grasp","tendons","fit","time"],jC=({target:n})=>n.matches?.("input, select, textarea")||document.querySelector("dialog[open]"),px=({ctrlKey:n,altKey:t,metaKey:e})=>!n&&!t&&!e;function mx(n){let t=s=>document.getElementById(s)?.click(),e={z:s=>t(s.shiftKey?"redo":"undo"),y:()=>t("redo"),o:()=>t("open"),s:()=>t("save")},i={"?":()=>n.help(),Escape:()=>n.select(null),g:()=>t("do-grasp"),o:()=>t("do-open"),c:()=>t("do-close"),".":()=>n.stepTime(1)};ZC.forEach((s,r)=>i[r+1]=()=>n.tabs.choose(s)),addEventListener("keydown",s=>{if(jC(s))return;let r=(s.ctrlKey||s.metaKey)&&!s.altKey,o=s.key.length===1?s.key.toLowerCase():s.key,a=r?e[o]:px(s)?i[o]:null;if(a)return s.preventDefault(),a(s);s.key===" "&&!s.target.matches("button, summary, a")&&(s.preventDefault(),n.togglePlay())})}function dx(n,t){let e=Mr(n.store.scene??{bodies:[]});if(!e.length)return;let i=e.findIndex(({name:r})=>r===n.store.selected?.owner),s=i<0?t>0?0:e.length-1:(i+t+e.length)%e.length;n.select({owner:e[s].name})}function fx(n,t){let{scene:e,selected:i}=n.store,s=i?.owner??e?.joints[0]?.hand,r=(e?.joints??[]).filter(l=>l.hand===s&&!l.led_by);if(!r.length)return;let o=r.findIndex(({name:l})=>l===i?.joint),a=o<0?t>0?0:r.length-1:(o+t+r.length)%r.length;n.select({owner:s,joint:r[a].name})}function JC(n,t){let{scene:e,frame:i,selected:s}=n.store,r=e.joints.findIndex(c=>c.hand===s.owner&&c.name===s.joint),o=e.joints[r];if(!o||!i)return;let a=n.wanted?.joint===o?n.wanted.value:i.joints[r],{scale:l}=Ys(o);n.moveJoint(o,_s(a+t*l,o.lower,o.upper))}function gx(n){let{stage:t,place:e}=n.picture,i={axis:"x",turns:!1},s=()=>n.notices.say(`arrow keys ${i.turns?"turn about":"move along"} ${i.axis}`),r=c=>{let h=$C[i.axis],d=i.turns?e.nudge({about:h,angle:c*qC}):e.nudge({by:new R(...h).multiplyScalar(c*YC).toArray()});if(!d)return;t.draw();let u=d.position.map(f=>(f*1e3).toFixed(1)).join(", ");n.notices.say(`${n.store.selected.owner} at ${u} mm`)},o=c=>()=>{Object.assign(i,c),s()},a={x:o({axis:"x"}),y:o({axis:"y"}),z:o({axis:"z"}),t:o({turns:!1}),r:o({turns:!0}),PageDown:()=>dx(n,1),PageUp:()=>dx(n,-1),"]":()=>fx(n,1),"[":()=>fx(n,-1)},l={"+":1,"=":1,"-":-1,_:-1,"*":10};t.canvas.addEventListener("keydown",c=>{if(!px(c))return;let{selected:h}=n.store,d=u=>{c.preventDefault(),c.stopImmediatePropagation(),u()};if(Object.hasOwn(a,c.key))return d(a[c.key]);if(h?.joint){let u=l[c.key]??np[c.key];u&&d(()=>JC(n,u*(c.shiftKey&&u**2===1?10:1)))}else e.shown()&&np[c.key]&&d(()=>r(np[c.key]))},{capture:!0}),wu(t.controls,t.canvas,()=>n.view.fit())}function ip(n,t,e={}){let i=qs("menu");t.id=i,t.classList.add("items");let s=De(n,()=>o(s.getAttribute("aria-expanded")!=="true"),{class:"opener","aria-expanded":"false","aria-controls":i,...e}),r=X("div",{class:"menu"},s,t);function o(a){if(s.setAttribute("aria-expanded",String(a)),r.classList.toggle("open",a),a){let{left:l,bottom:c}=s.getBoundingClientRect();t.style.setProperty("--left",`${Math.max(8,Math.min(l,innerWidth-250))}px`),t.style.setProperty("--top",`${c+4}px`),t.querySelector("button, input")?.focus()}}return r.addEventListener("keydown",a=>{a.key!=="Escape"||!r.classList.contains("open")||(a.stopPropagation(),o(!1),s.focus())}),addEventListener("pointerdown",({target:a})=>r.contains(a)||o(!1)),r.addEventListener("click",({target:a})=>{a.closest(".items")&&a.matches("button")&&o(!1)}),r}function KC(n){let t=X("div",{},Be("New",n.newWorld,{id:"new",title:"An empty world"}),De("Open",()=>n.openDialog(),{id:"open",title:"Worlds, scenes, digits, hands, objects (Ctrl+O)"}),Be("Save",n.save,{id:"save",title:"Save or download the world (Ctrl+S)"}),De("Import",()=>n.importFiles(),{id:"import",title:"Meshes, robots, worlds; or drop files onto the picture"})),e=ip("File",t);return e.classList.add("file"),e}function QC(n){let t=Be("Begin a film (WebM)",async()=>{t.textContent=await n.film()?"End the film":"Begin a film (WebM)"},{id:"film"});return ip("Export",X("div",{},Be("Picture (PNG)",n.savePicture,{id:"export-png"}),Be("Scene (glTF)",n.saveGltf,{id:"export-gltf"}),Be("Charts (SVG)",n.saveCharts,{id:"export-svg"}),t,De("Print the picture",()=>print())))}function tR(n){let{picture:t,view:e}=n,i=(r,o)=>{let a=xs({name:r,lower:0,upper:1,quantity:Gi.share},l=>e.opacity(o,l));return a.set(t.bodies.opacities[o]),a},s=(r,o,a)=>wl(r,o,a);return ip("View",X("div",{class:"view-menu"},i("skin","hands"),i("objects","objects"),s("grid",!0,e.grid),s("shadows",!0,e.shadows),s("names",!1,e.names),s("contacts",!0,r=>e.contacts("contacts",r)),s("friction cones",!0,r=>e.contacts("cones",r)),s("contact forces",!0,r=>e.contacts("forces",r)),s("tendons",!0,e.lines),s("arrows",!0,e.vectors),De("Show everything",()=>e.fit())))}function _x(n){let{store:t}=n,e=X("span",{class:"world-name"}),i=X("span",{class:"link",role:"status"}),s=Be("Undo",()=>n.ask("session.undo"),{id:"undo"}),r=Be("Redo",()=>n.ask("session.redo"),{id:"redo"}),o=X("header",{class:"bar"},X("h1",{},"thenar"),KC(n),X("div",{class:"group"},s,r),QC(n),tR(n),De("?",()=>n.help(),{id:"help","aria-label":"Help: all keys",title:"Help (?)"}),e,i),a=()=>{let{state:l,link:c}=t;s.disabled=!l?.undo,r.disabled=!l?.redo,s.title=l?.undo?`Undo: ${l.undo} (Ctrl+Z)`:"Nothing to undo",r.title=l?.redo?`Redo: ${l.redo} (Ctrl+Y)`:"Nothing to redo";let h=l?.world??{};e.textContent=[h.name??"",h.unsaved?"(not saved)":""].filter(Boolean).join(" "),document.title=h.name?`${h.name} \u2013 thenar`:"thenar";let d=(l?.clients??1)-1;i.className=c?"link on":"link off",i.textContent=c?d>0?`connected, with ${d} more`:"connected":"not connected"};return t.on(["state","link"],a),a(),o}var no=n=>n?n.map(t=>pe(t,2)).join(", "):"n/a",xx=({trial:n,specimen:t,posture:e,loads:i})=>[`${n+1}`,t,e,i].filter(s=>s&&s!=="").join(" "),yx=Math.PI/180;function sp({value:n,lower:t,upper:e},i,s){let r=a=>pe(a===null?NaN:a/i,1),o=t===e?"":` (${r(t)} to ${r(e)})`;return`${r(n)}${o}${s}`}var eR=({angle:n,distance:t,beyond:e})=>[["Angle",sp(n,yx,"\xB0")],["Distance",sp(t,.001,"\u202Fmm")],["Beyond",sp(e,.001,"\u202Fmm")]],nR=({direction:n,point:t})=>[["Direction",no(n)],["Point",`${no(t.map(e=>e*1e3))} mm`]];function vx(n){let{store:t}=n,e=X("p",{class:"hint"},"No fit is shown."),i=Jh("Fit",u=>n.ask("fit.open",{file:u})),s=Vn("Trial",async u=>{await n.ask("fit.trial",{trial:Number(u)}),d()}),r=X("div",{}),o=Zs(["trial","measured [N]","predicted [N]"],[],"Forces"),a=X("div",{}),l=X("div",{},s,qe("This trial",r),qe("All trials",o),qe("Axes",a)),c=X("div",{class:"page fit"},e,i,aa(n),l);function h(u){let f=u.trials;s.set(f.map(_=>({value:String(_.trial),text:xx(_)})),String(u.trial));let p=f.find(_=>_.trial===u.trial);r.replaceChildren(wr(p?[["Measured",`${no(p.measured)} N`],["Predicted",`${no(p.predicted)} N`],["Sd",`${no(p.sd)} N`],["Direction off by",`${pe(p.direction_error/yx,1)}\xB0`]]:[]),...(u.warnings??[]).map(_=>X("p",{class:"warning"},_))),js(o.querySelector("tbody"),f.map(_=>[xx(_),no(_.measured),no(_.predicted)])),a.replaceChildren(...u.pairs.map(_=>qe(_.axes,wr(eR(_)))),...u.axes.map(_=>qe(_.joint,wr(nR(_)))))}async function d(){let u=t.scene?.mode==="fit";if(e.hidden=u,l.hidden=!u,!u||c.hidden)return;let f=await n.ask("fit.state");f&&h(f)}return t.on(["scene","tab"],d),d(),c}var iR=20,sR=n=>[n.link,pe(n.depth*1e3,2),pe(n.area*1e6,1),`${pe(100*n.stick,0)} %`];function Sx(n,t){let e=1,i=xs({name:"force of each",lower:.1,upper:iR,quantity:Gi.force},l=>e=l);i.set(e);let r=Zs(["pad","depth [mm]","area [mm\xB2]","sticks"],[],"Pads");r.hidden=!0;let o=X("p",{class:"hint"});return qe("Pads",i,X("div",{class:"buttons"},Be("Press",async()=>{let l=await n.ask("grasp.pads",{...t(),force:e});l&&(r.hidden=l.pads.length===0,js(r.querySelector("tbody"),l.pads.map(sR)),o.textContent=l.reasons.length?l.reasons.join(`
`):"On the picture: blue points stick, orange ones slip; larger is more pressure.",n.picture.pads.show(l.pads.flatMap(({points:c})=>c)))},{id:"press-pads"})),r,o)}var rR=new R(0,1,0);function Dl(n,t,e){return n.position.copy(t).add(e).multiplyScalar(.5),n.quaternion.setFromUnitVectors(rR,e.clone().sub(t).normalize()),n}function bx({a:n,b:t,radius:e},{material:i,size:s}){let r=new R(...n),o=new R(...t),a=new mt(new Vr(e??.02*s,r.distanceTo(o),8,20),i);return Dl(a,r,o),a.userData.labelAt=a.position.clone(),a}function wx({positions:n,radius:t},{material:e,size:i}){let s=new zs(new ui(t??.008*i,12,8),e,n.length);return n.forEach((r,o)=>s.setMatrixAt(o,new Kt().makeTranslation(...r))),s.userData.labelAt=new R(...n[0]??[0,0,0]),s}var oR=.5;function Mx({tip:n,axis:t,radius:e},{color:i}){let s=new R(...n),r=s.clone().add(new R(...t)),o=new Jn({color:i,transparent:!0,opacity:oR,side:on,depthWrite:!1}),a=s.distanceTo(r),l=Dl(new mt(new Bi(e,a,28,1,!0),o),r,s);return l.userData.labelAt=s,l}function Ex(n,t,e,i,s){let r=t.clone().sub(n),o=r.length(),a=new Te;if(o===0)return a;let l=Math.min(i,.5*o),c=t.clone().addScaledVector(r,-l/o);return a.add(Dl(new mt(new Ge(e,e,o-l,12),s),n,c)),a.add(Dl(new mt(new Bi(2.6*e,l,16),s),c,t)),a}function Ax({from:n,vector:t,radius:e},{material:i,size:s}){let r=new R(...n),o=r.clone().add(new R(...t)),a=Ex(r,o,e??.005*s,.035*s,i);return a.userData.labelAt=o,a}function Tx({point:n,direction:t,length:e},{material:i,size:s}){let r=new R(...t).normalize().multiplyScalar((e??.2*s)/2),o=new R(...n),a=o.clone().add(r),l=Ex(o.clone().sub(r),a,.0035*s,.025*s,i);return l.userData.labelAt=a,l}var aR=.3,Cx=Math.PI/2,Rx={cylinder:([n,t])=>new Ge(n,n,2*t,40,1,!0).rotateX(Cx),sphere:([n])=>new ui(n,32,20),ellipsoid:([n,t,e])=>new ui(1,32,20).scale(n,t,e),capsule:([n,t])=>new Vr(n,2*t,12,32).rotateX(Cx),torus:([n,t])=>new Ai(t,n,16,48)},nF=Object.keys(Rx);function Px({shape:n,size:[t,e=0,i=0]}){return n==="cylinder"?Math.hypot(t,e):n==="ellipsoid"?Math.max(t,e,i):n==="sphere"?t:t+e}function Ix({shape:n,size:t,center:e,axes:i},{color:s}){let r=new Jn({color:s,transparent:!0,opacity:aR,side:on,depthWrite:!1}),o=new mt(Rx[n](t),r),[a,l,c]=i.map(h=>new R(...h));return o.applyMatrix4(new Kt().makeBasis(a,l,c).setPosition(...e)),o.userData.hull=!0,o.userData.labelAt=new R(...e),o}var lR=65536,cR=.62,op=n=>Uint8Array.from(atob(n),t=>t.charCodeAt(0)).buffer;function hR(n){let t=new Uint8Array(op(n)),e=new Float32Array(t.length),i=new Zt;for(let s=0;s<t.length;s+=3)i.setRGB(t[s]/255,t[s+1]/255,t[s+2]/255,"srgb").toArray(e,s);return e}function uR({vertices:n,origin:t,step:e,triangles:i,crease:s,colors:r}){let o=new Int16Array(op(n)),a=Float32Array.from(o,(h,d)=>t[d%3]+e*h),l=a.length/3>lR?Uint32Array:Uint16Array,c=new Me;if(c.setAttribute("position",new hn(a,3)),r&&c.setAttribute("color",new hn(hR(r),3)),c.setIndex(new hn(new l(op(i)),1)),s===void 0)c.computeVertexNormals();else return nu(c,s*Math.PI/180);return c}var rp=new WeakMap;function Lx(n){return rp.has(n)||rp.set(n,uR(n)),rp.get(n)}function Dx({rotation:n,position:t=[0,0,0]}){let[e,i,s]=n??[[1,0,0],[0,1,0],[0,0,1]],[[r,o,a],[l,c,h],[d,u,f]]=[e,i,s],[p,_,m]=t;return new Kt().set(r,o,a,p,l,c,h,_,d,u,f,m,0,0,0,1)}function Nx(n,t){let e=Dx(t),{position:i}=Lx(t.mesh).attributes,s=new R;for(let r=0;r<i.count;++r)n.expandByPoint(s.fromBufferAttribute(i,r).applyMatrix4(e))}function dR(n,t,e){n.solids??(n.solids=new Map);let i=`${t} ${e}`;return n.solids.has(i)||n.solids.set(i,new el({color:e?16777215:n.color,vertexColors:e,roughness:cR,transparent:t<1,opacity:t,depthWrite:t===1,side:t<1?on:0})),n.solids.get(i)}function Ox(n,t){let{mesh:e,opacity:i=1}=n,s=new mt(Lx(e),dR(t,i,e.colors!==void 0));return s.applyMatrix4(Dx(n)),s.castShadow=s.receiveShadow=!0,s.userData.hull=i<1,s.geometry.computeBoundingSphere(),s.userData.labelAt=s.geometry.boundingSphere.center.clone().applyMatrix4(s.matrix),s}var ua=class extends Rr{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setPositions(i),this}setColors(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setColors(i),this}setFromPoints(t){let e=t.length-1,i=new Float32Array(6*e);for(let s=0;s<e;s++)i[6*s]=t[s].x,i[6*s+1]=t[s].y,i[6*s+2]=t[s].z||0,i[6*s+3]=t[s+1].x,i[6*s+4]=t[s+1].y,i[6*s+5]=t[s+1].z||0;return super.setPositions(i),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Mu=class extends la{constructor(t=new ua,e=new ys({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var fR=.35,pR=.15,mR=2.5;function gR(n,t){let e=new Me;e.setAttribute("position",new ie(n.flat(),3)),e.setIndex(t.flat());let i=e.toNonIndexed();return i.computeVertexNormals(),i}function Ux({vertices:n,faces:t},{color:e}){let i=gR(n,t),s=new Te,r=new Jn({color:e,transparent:!0,opacity:fR,side:on,depthWrite:!1});return s.add(new mt(i,r),new Gs(new Qa(i,5),new Fi({color:e}))),s.children[0].userData.hull=!0,i.computeBoundingSphere(),s.userData.labelAt=i.boundingSphere?.center??new R,s}function Fx({positions:n,dashed:t=!1,width:e=mR},{color:i,size:s}){if(n.length<2)return new Te;let r=new ys({color:i,linewidth:e*(globalThis.devicePixelRatio??1),dashed:t,dashSize:.015*s,gapSize:.01*s}),o=new Mu(new ua().setPositions(n.flat()),r);return o.computeLineDistances(),o.userData.labelAt=new R(...n[Math.floor(n.length/2)]),o}function Bx({positions:n,opacity:t=pR},{color:e}){let i=new Me;i.setAttribute("position",new ie(n.flat(),3));let s=new Fi({color:e,transparent:!0,opacity:t,depthWrite:!1}),r=new Gs(i,s);return r.userData.labelAt=new R(...n[0]??[0,0,0]),r}var _R={segment:bx,axis:Tx,arrow:Ax,hull:Ux,points:wx,line:Fx,lines:Bx,surface:Ix,mesh:Ox,cone:Mx},Eu=n=>n!==null&&typeof n=="object"?Object.entries(n).every(([t,e])=>t==="label"||Eu(e)):n!==null&&!Number.isNaN(n);function xR(n){let t=new Map;return e=>(t.has(e)||t.set(e,{color:new Zt(e),material:new Jn({color:e}),size:n}),t.get(e))}function yR(n,t){let e=new Te,i=[],s=xR(t),r=n.items.filter(Eu);for(let o of r){let a=_R[o.kind](o,s(o.color??n.color));e.add(a),o.label&&i.push({position:a.userData.labelAt,text:o.label})}return e.name=n.name,e.visible=n.visible!==!1,{group:e,labels:i,name:n.name,color:n.color,time:n.time??null,lost:n.items.length-r.length}}var kx=(n,t)=>n.map(e=>yR(e,t));var ap=(n,t,e)=>n.map((i,s)=>i+e*t[s]);function vR(n){let t=Math.hypot(...n)||1;return n.map(e=>e/t)}function SR(n){return n.kind==="segment"?[n.a,n.b]:n.kind==="arrow"?[n.from,ap(n.from,n.vector,1)]:n.kind==="cone"?[n.tip,ap(n.tip,n.axis,1)]:n.kind==="axis"?[-.5,.5].map(t=>ap(n.point,vR(n.direction),t*(n.length??0))):n.kind==="surface"?[-1,1].map(t=>n.center.map(e=>e+t*Px(n))):n.vertices??n.positions}function zx(n){let t=new tn,e=new R,i=n.filter(({fit:s})=>s!==!1);for(let s of i.flatMap(r=>r.items).filter(Eu)){if(s.kind==="mesh"){Nx(t,s);continue}for(let r of SR(s))t.expandByPoint(e.fromArray(r));if(s.radius&&s.kind==="segment")for(let r of[s.a,s.b])for(let o of[-1,1])t.expandByPoint(e.fromArray(r).addScalar(o*s.radius))}return t}var Gx=n=>n.isEmpty()?1:n.getSize(new R).length()||1;var Ir=class n{constructor(t,e,i,s,r="div"){this.parent=t,this.object=e,this.property=i,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),n.nextNameID=n.nextNameID||0,this.$name.id=`lil-gui-name-${++n.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(i)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},lp=class extends Ir{constructor(t,e,i){super(t,e,i,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function cp(n){let t,e;return(t=n.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=n.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=n.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var bR={isPrimitive:!0,match:n=>typeof n=="string",fromHexString:cp,toHexString:cp},Ol={isPrimitive:!0,match:n=>typeof n=="number",fromHexString:n=>parseInt(n.substring(1),16),toHexString:n=>"#"+n.toString(16).padStart(6,0)},wR={isPrimitive:!1,match:n=>Array.isArray(n)||ArrayBuffer.isView(n),fromHexString(n,t,e=1){let i=Ol.fromHexString(n);t[0]=(i>>16&255)/255*e,t[1]=(i>>8&255)/255*e,t[2]=(i&255)/255*e},toHexString([n,t,e],i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return Ol.toHexString(s)}},MR={isPrimitive:!1,match:n=>Object(n)===n,fromHexString(n,t,e=1){let i=Ol.fromHexString(n);t.r=(i>>16&255)/255*e,t.g=(i>>8&255)/255*e,t.b=(i&255)/255*e},toHexString({r:n,g:t,b:e},i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return Ol.toHexString(s)}},ER=[bR,Ol,wR,MR];function AR(n){return ER.find(t=>t.match(n))}var hp=class extends Ir{constructor(t,e,i,s){super(t,e,i,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=AR(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=cp(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Nl=class extends Ir{constructor(t,e,i){super(t,e,i,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},up=class extends Ir{constructor(t,e,i,s,r,o){super(t,e,i,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let x=parseFloat(this.$input.value);isNaN(x)||(this._stepExplicit&&(x=this._snap(x)),this.setValue(this._clamp(x)))},i=x=>{let b=parseFloat(this.$input.value);isNaN(b)||(this._snapClampSetValue(b+x),this.$input.value=this.getValue())},s=x=>{x.key==="Enter"&&this.$input.blur(),x.code==="ArrowUp"&&(x.preventDefault(),i(this._step*this._arrowKeyMultiplier(x))),x.code==="ArrowDown"&&(x.preventDefault(),i(this._step*this._arrowKeyMultiplier(x)*-1))},r=x=>{this._inputFocused&&(x.preventDefault(),i(this._step*this._normalizeMouseWheel(x)))},o=!1,a,l,c,h,d,u=5,f=x=>{a=x.clientX,l=c=x.clientY,o=!0,h=this.getValue(),d=0,window.addEventListener("mousemove",p),window.addEventListener("mouseup",_)},p=x=>{if(o){let b=x.clientX-a,v=x.clientY-l;Math.abs(v)>u?(x.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(b)>u&&_()}if(!o){let b=x.clientY-c;d-=b*this._step*this._arrowKeyMultiplier(x),h+d>this._max?d=this._max-h:h+d<this._min&&(d=this._min-h),this._snapClampSetValue(h+d)}c=x.clientY},_=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",p),window.removeEventListener("mouseup",_)},m=()=>{this._inputFocused=!0},g=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",m),this.$input.addEventListener("blur",g)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(g,x,b,v,C)=>(g-x)/(b-x)*(C-v)+v,e=g=>{let x=this.$slider.getBoundingClientRect(),b=t(g,x.left,x.right,this._min,this._max);this._snapClampSetValue(b)},i=g=>{this._setDraggingStyle(!0),e(g.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=g=>{e(g.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,l,c=g=>{g.preventDefault(),this._setDraggingStyle(!0),e(g.touches[0].clientX),o=!1},h=g=>{g.touches.length>1||(this._hasScrollBar?(a=g.touches[0].clientX,l=g.touches[0].clientY,o=!0):c(g),window.addEventListener("touchmove",d,{passive:!1}),window.addEventListener("touchend",u))},d=g=>{if(o){let x=g.touches[0].clientX-a,b=g.touches[0].clientY-l;Math.abs(x)>Math.abs(b)?c(g):(window.removeEventListener("touchmove",d),window.removeEventListener("touchend",u))}else g.preventDefault(),e(g.touches[0].clientX)},u=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",d),window.removeEventListener("touchend",u)},f=this._callOnFinishChange.bind(this),p=400,_,m=g=>{if(Math.abs(g.deltaX)<Math.abs(g.deltaY)&&this._hasScrollBar)return;g.preventDefault();let b=this._normalizeMouseWheel(g)*this._step;this._snapClampSetValue(this.getValue()+b),this.$input.value=this.getValue(),clearTimeout(_),_=setTimeout(f,p)};this.$slider.addEventListener("mousedown",i),this.$slider.addEventListener("touchstart",h,{passive:!1}),this.$slider.addEventListener("wheel",m,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:i}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,i=-t.wheelDelta/120,i*=this._stepExplicit?1:10),e+-i}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},dp=class extends Ir{constructor(t,e,i,s){super(t,e,i,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let i=document.createElement("option");i.textContent=e,this.$select.appendChild(i)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},fp=class extends Ir{constructor(t,e,i){super(t,e,i,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},TR=`.lil-gui {
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
}`;function CR(n){let t=document.createElement("style");t.innerHTML=n;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var Vx=!1,Au=class n{constructor({parent:t,autoPlace:e=t===void 0,container:i,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:l=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),l&&this.domElement.classList.add("lil-allow-touch-styles"),!Vx&&a&&(CR(TR),Vx=!0),i?i.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,i,s,r){if(Object(i)===i)return new dp(this,t,e,i);let o=t[e];switch(typeof o){case"number":return new up(this,t,e,i,s,r);case"boolean":return new lp(this,t,e);case"string":return new fp(this,t,e);case"function":return new Nl(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,i=1){return new hp(this,t,e,i)}addFolder(t){let e=new n({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(i=>{i instanceof Nl||i._name in t.controllers&&i.load(t.controllers[i._name])}),e&&t.folders&&this.folders.forEach(i=>{i._title in t.folders&&i.load(t.folders[i._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(i=>{if(!(i instanceof Nl)){if(i._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${i._name}"`);e.controllers[i._name]=i.save()}}),t&&this.folders.forEach(i=>{if(i._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${i._title}"`);e.folders[i._title]=i.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let i=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",i))};this.$children.addEventListener("transitionend",i);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(i=>i.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};var RR=700,PR=400;function IR(n,{group:t,name:e,color:i},s){let r=n.add(t,"visible").name(e).onChange(s);r.domElement.style.setProperty("--layer",i),r.domElement.classList.add("layer")}function LR(n){let t=[];for(let{group:e}of n)e.traverse(i=>i.userData.hull&&t.push(i.material));return t}function DR(n,t,e){let i=LR(t);if(!i.length)return;let s={"surface opacity":i[0].opacity};n.add(s,"surface opacity",0,1,.05).onChange(r=>{for(let o of i)o.opacity=r;e()})}function Hx(n,t){let e=new Au({container:n,title:"Layers",width:190});for(let i of t.layers)i.time===null&&IR(e,i,t.draw);return DR(e,t.layers,t.draw),t.layers.some(i=>i.labels.length)&&e.add(t.show,"labels").onChange(t.draw),e.add(t.grid,"visible").name("grid").onChange(t.draw),e.add(t,"fit").name("fit view"),n.clientWidth<RR&&e.close(),e.onOpenClose(()=>setTimeout(t.draw,PR)),e}var pp=new Map,mp=!1;function NR(n,t){let e=t.view.camera.position.clone().sub(t.controls.target),i=n.view.camera.position.distanceTo(n.controls.target);n.view.camera.position.copy(n.controls.target).addScaledVector(e.normalize(),i),n.view.camera.zoom=t.view.camera.zoom,n.view.camera.updateProjectionMatrix(),n.controls.update(),n.view.draw()}function Wx(n,t,e){let i=pp.get(n)??[],s={view:t,controls:e};pp.set(n,[...i,s]),e.addEventListener("change",()=>{mp||(mp=!0,pp.get(n).filter(r=>r!==s).forEach(r=>NR(r,s)),mp=!1)})}var da=null;function gp(){return da||(da=new na({antialias:!0,alpha:!0}),da.shadowMap.enabled=!0,da.shadowMap.type=Hs,da)}function Xx(n,t,e){let{width:i,height:s}=n.canvas,r=gp(),o=r.domElement;(o.width!==i||o.height!==s)&&r.setSize(i,s,!1),r.render(t,e),n.clearRect(0,0,i,s),n.drawImage(r.domElement,0,0)}function OR(n){let t=document.createElement("canvas");return t.tabIndex=0,t.setAttribute("role","img"),t.setAttribute("aria-label",`${n.dataset.label??"3D view"}; arrow keys turn, plus and minus zoom, 0 fits`),n.append(t),t}function UR(n,t,e,i){return!n.some(({items:r})=>r.some(({kind:o})=>o==="mesh"))||t.isEmpty()?null:{from:i,center:t.getCenter(new R),radius:.75*e}}function FR({layers:n,up:t=[0,0,1],view:e}){let i=zx(n),s=Gx(i),r=new R(...t).normalize(),o=new Gr,a=mu(r),l=kx(n,s),{grid:c}=gu(i,s,r);c.visible=n.every(({fit:d})=>d!==!1),o.add(c,...l.map(d=>d.group));let h=e?new R(...e).normalize():Il(r);return _u(o,a,r,UR(n,i,s,h)),{scene:o,camera:a,box:i,grid:c,layers:l,show:{labels:!0},from:h}}function BR(n){if(!n)return[];let{offsetLeft:t,offsetTop:e,offsetWidth:i,offsetHeight:s}=n.domElement;return[{left:t,top:e,right:t+i,bottom:e+s}]}function qx(n,t,e,{unit:i="mm",compact:s},r,o){let{canvas:a}=t,l={width:a.width/r,height:a.height/r},c={...e(),...l,compact:s};Xx(t,n.scene,n.camera),t.save(),t.scale(r,r);let h=n.layers.filter(d=>d.group.visible).flatMap(d=>d.labels);n.show.labels&&xu(t,h,n.camera,c,o),s||vu(t,n.camera,c),yu(t,n.camera,i,c),t.restore()}function $x(n,t){n.traverse(({material:e})=>{e?.isLineMaterial&&(e.linewidth*=t)})}function Zx(n,t,e,i,s){let r=document.createElement("canvas");r.width=Math.max(1,Math.round(t.width*s)),r.height=Math.max(1,Math.round(t.height*s));let o=r.getContext("2d"),a=s/devicePixelRatio;return $x(n.scene,a),ha(n.camera,r.width/r.height),qx(n,o,e,i,s,[]),$x(n.scene,1/a),o.globalCompositeOperation="destination-over",o.fillStyle=e().page,o.fillRect(0,0,r.width,r.height),r}function kR(n,t,e,i,s){let r=n.camera.clone(!1);return Ll(r,n.box,t.width/t.height,n.from),Zx({...n,camera:r},t,e,{...i,compact:!0},s)}function Yx(n,t){return n.width=Math.max(1,Math.round(t.clientWidth*devicePixelRatio)),n.height=Math.max(1,Math.round(t.clientHeight*devicePixelRatio)),n.width/n.height}function zR(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function jx(n,t,e){gp();let i=OR(n),s=i.getContext("2d"),r=FR(t),o=()=>qx(r,s,e,t,devicePixelRatio,BR(r.panel));r.draw=zR(o);let a=()=>({width:n.clientWidth,height:n.clientHeight});r.picture=c=>Zx(r,a(),e,t,c),r.still=(c,h)=>kR(r,c,e,t,h),r.paintNow=o;let l=ux(r.camera,i,r.draw);return r.fit=()=>{l.target.copy(Ll(r.camera,r.box,i.width/i.height,r.from)),l.update(),r.draw()},i.addEventListener("dblclick",r.fit),wu(l,i,r.fit),Yx(i,n),r.fit(),t.compact||(r.panel=Hx(n,r)),t.link&&Wx(t.link,r,l),new ResizeObserver(()=>{n.clientWidth&&(ha(r.camera,Yx(i,n)),o())}).observe(n),r.lost=r.layers.reduce((c,h)=>c+h.lost,0),r}var Jx=["Fx","Fy","Fz","Tx","Ty","Tz"],_p={"force, no torque":{axes:[0,1,2],kind:"slice"},"torque, no force":{axes:[3,4,5],kind:"slice"},"force, any torque":{axes:[0,1,2],kind:"projection"},"torque, any force":{axes:[3,4,5],kind:"projection"},"three axes":null},GR=[{limits:"geometric",title:"Contacts alone",color:"#0072b2"},{limits:"actuated",title:"With the hand's limits",color:"#d55e00"}],Kx="#8a8f99";function VR(n,t){let e=s=>Math.max(1e-9,...n.map(r=>Math.abs(r[s]))),i=Math.max(e(0),e(1),e(2));return t.map((s,r)=>{let o=[0,0,0];return o[r]=1.15*Math.max(e(r),.25*i),{kind:"arrow",from:[0,0,0],vector:o,label:Jx[s],color:Kx}})}function HR(n,t,e,i){let s=X("div",{class:"scene small"});s.dataset.label=`${n.title}: set of wrenches`;let r=t.vertices.length<4,o="The set has no volume along these axes.",a=t.failed?`; ${t.failed} directions have no bound`:"",l=X("figcaption",{},`${n.title} [${t.unit}]${a}`);if(r)s.append(X("p",{class:"hint"},o));else{let c={kind:"hull",vertices:t.vertices,faces:t.triangles},d={layers:[{name:"set",color:n.color,items:[c]},{name:"axes",color:Kx,items:VR(t.vertices,e)}],compact:!0,unit:t.unit.split(" ")[0],link:i};requestAnimationFrame(()=>jx(s,d,()=>({ink:rn("--ink"),page:rn("--page")})))}return X("figure",{class:"wrenches"},s,l)}var WR=0;function Qx(n,t){let e=X("div",{class:"pair"}),i=[0,1,2].map(l=>{let c=Vn(`Axis ${l+1}`,()=>{});return c.set(Jx.map((h,d)=>({value:String(d),text:h})),String(l)),c}),s=X("div",{class:"axes",hidden:!0},...i),r=Vn("Set",l=>s.hidden=_p[l]!==null);r.set(Object.keys(_p),"force, no torque");let o=()=>_p[r.value()]??{axes:i.map(l=>Number(l.value())),kind:"projection"};return qe("Wrench space",r,s,X("div",{class:"buttons"},Be("Show",async()=>{let l=o();if(new Set(l.axes).size<3)return n.notices.error("Choose three different axes.");let c=`wrenches ${++WR}`,h=[];for(let d of GR){let u={...t(),...l,limits:d.limits},f=await n.ask("grasp.wrench_set",u);if(!f)return;h.push(HR(d,f,l.axes,c))}e.replaceChildren(...h)},{id:"show-wrenches"})),e)}var XR=350,$R=["fx","fy","fz","tx","ty","tz"],ty=(n,t)=>n??t.map((e,i)=>`${$R[i]} ${pe(e,3)}`).join(", ");function YR(n){let{closed:t,epsilon:e,volume:i}=n;if(!t||!e)return[["Grasp",n.reason??n.verdict??"nothing is held"]];let s=[["Force closure",n.force_closure?"\u2713 yes":"\u2717 no: the grasp is unstable"],["Epsilon",pe(e.lower)],["certified",`${pe(e.lower)} to ${pe(e.upper)}`]];return n.missing_direction&&s.push(["Cannot resist",ty(n.missing_direction_words,n.missing_direction)]),n.worst_wrench&&s.push(["Worst disturbance",ty(n.worst_wrench_words,n.worst_wrench)]),i&&s.push(["Volume",`${pe(i.lower)} to ${pe(i.upper)}`]),n.contacts!==void 0&&s.push(["Contacts",String(n.contacts)]),s}function qR({outcome:n,explanation:t,stopped:e=[]}){let i=e.map(({joint:s,by:r})=>`${s}: ${r}`);return[t||n,i.length?`Joints stopped by: ${i.join(", ")}`:""].filter(Boolean).join(`
`)}function ey(n){let{store:t}=n,e=Vn("Hand",()=>u()),i=Vn("Object",()=>u()),s=X("p",{class:"outcome",role:"status"}),r=X("div",{class:"quality",role:"status",id:"quality"}),o=wl("volume too (slower)",!1,()=>u()),a=wl("follow every move",!0,()=>u()),l="",c=()=>({...e.value()?{hand:e.value()}:{},...i.value()?{object:i.value()}:{}}),h=x=>async()=>{let b=await n.ask(x,c());b&&(s.textContent=qR(b),s.textContent&&n.notices.say(s.textContent),await u())},d=()=>t.scene?.mode==="world"&&e.value()&&i.value()&&n.link.connected();async function u(){if(!d())return r.replaceChildren();if(l=f(),!t.frame?.contacts.length&&!o.box.checked)return m.quality=null,r.replaceChildren(X("p",{class:"hint"},"Nothing touches the object."));let x=l,b=await n.ask("grasp.quality",{...c(),volume:o.box.checked});!b||x!==l||(m.quality=b,r.classList.toggle("holds",!!b.force_closure),r.replaceChildren(wr(YR(b)),...Kh(b.warnings)))}let f=()=>t.frame?`${t.frame.revision} ${t.frame.bodies.join()}`:"",p=tu(()=>{!m.hidden&&a.box.checked&&f()!==l&&u()},XR),_=[["Open","hand.open"],["Approach","hand.approach"],["Close","hand.close"],["Grasp","hand.grasp"]].map(([x,b])=>Be(x,h(b),{id:`do-${x.toLowerCase()}`,class:x==="Grasp"?"main":null})),m=X("div",{class:"page grasp"},e,i,X("div",{class:"buttons"},..._),s,qe("Quality",r,X("div",{class:"ticks"},a,o),X("div",{class:"buttons"},Be("Ask now",u,{id:"ask-quality"}))),Qx(n,c),Sx(n,c)),g=()=>{let x=t.scene?Mr(t.scene):[],b=C=>x.filter(E=>E.kind===C).map(({name:E})=>E);e.set(b("hand")),i.set(b("object")),e.hidden=b("hand").length<2,i.hidden=b("object").length<2;let v=!b("hand").length||!b("object").length||t.scene?.mode!=="world";_.forEach((C,E)=>C.disabled=E===0?!b("hand").length:v),p()};return t.on(["scene"],g),t.on(["frame","tab"],p),g(),m}var xp={worlds:{title:"Worlds",verb:"Open",ask:n=>["world.load",{world:n}]},scenes:{title:"Scenes in time",verb:"Open",ask:n=>["motion.open",{scene:n}]},subjects:{title:"Digits with tendons",verb:"Open"},hands:{title:"Hands",verb:"Add",ask:n=>["world.add_hand",{hand:n}]},objects:{title:"Objects",verb:"Add",ask:n=>["world.add_object",{object:n}]}},ZR=(n,t)=>{let e=[n.name,n.kind,n.about].join(" ").toLowerCase();return t.toLowerCase().split(/\s+/).every(i=>e.includes(i))},ny=({name:n,about:t},e,i)=>X("li",{},De(X("span",{},X("b",{},n),X("span",{class:"about"},t??"")),i,{"aria-label":`${e} ${n}`}));function iy(n){let t=new Map,e=X("input",{type:"search",placeholder:"Search","aria-label":"Search",autocomplete:"off"}),i=X("ul",{class:"catalogue"}),s=qs("open"),r=X("div",{class:"kinds",role:"group","aria-label":"Kind"}),o=X("h2",{id:s},"Open or add"),a=X("dialog",{"aria-labelledby":s,class:"open-dialog"},X("div",{class:"dialog-head"},o,De("\xD7",()=>a.close(),{"aria-label":"Close"})),r,e,i),l="worlds";async function c(p){if(!t.has(p)){let _=await n.ask("catalogue.list",{what:p});if(!_)return[];t.set(p,_.entries)}return t.get(p)}async function h(p){let m=(await n.ask("catalogue.list",{what:"digits",of:p.name}))?.entries??[],g=x=>{a.close(),n.ask("tendons.open",{subject:p.name,...x?{digit:x}:{}})};if(m.length<2)return g(m[0]?.name);i.replaceChildren(...m.map(({name:x,about:b})=>ny({name:x,about:b||p.name},"Open",()=>g(x)))),i.querySelector("button").focus()}async function d(p){if(l==="subjects")return h(p);a.close();let[_,m]=xp[l].ask(p.name);l==="worlds"&&!await n.mayLeave()||await n.ask(_,m)}async function u(){let p=l,_=await c(p);if(p!==l)return;let m=_.filter(g=>ZR(g,e.value));i.replaceChildren(...m.map(g=>ny(g,xp[p].verb,()=>d(g))),...m.length?[]:[X("li",{class:"hint"},"Nothing has that name.")])}function f(p){l=p;for(let _ of r.children)_.setAttribute("aria-pressed",String(_.dataset.kind===l));u()}for(let[p,{title:_}]of Object.entries(xp)){let m=De(_,()=>f(p),{class:"kind"});m.dataset.kind=p,r.append(m)}return e.addEventListener("input",u),e.addEventListener("keydown",p=>{p.key==="Enter"&&i.querySelector("button")?.click(),p.key==="ArrowDown"&&i.querySelector("button")?.focus()}),i.addEventListener("keydown",({key:p})=>{let _={ArrowDown:1,ArrowUp:-1}[p];if(!_)return;let m=[...i.querySelectorAll("button")];m[m.indexOf(document.activeElement)+_]?.focus()}),document.body.append(a),p=>{a.showModal(),e.value="",f(p??l),e.focus()}}var jR="uplot",JR="u-hz",KR="u-vt",QR="u-title",tP="u-wrap",eP="u-under",nP="u-over",iP="u-axis",ro="u-off",sP="u-select",rP="u-cursor-x",oP="u-cursor-y",aP="u-cursor-pt",lP="u-legend",cP="u-live",hP="u-inline",uP="u-series",dP="u-marker",sy="u-label",fP="u-value",Fl="width",Bl="height";var ry="bottom",fa="left",yp="right",Up="#000",oy=Up+"0",vp="mousemove",ay="mousedown",Sp="mouseup",ly="mouseenter",cy="mouseleave",hy="dblclick",pP="resize",mP="scroll",uy="change",Iu="dppxchange",Fp="--",va=typeof window<"u",Ap=va?document:null,ma=va?window:null,gP=va?navigator:null,Re,Tu;function Tp(){let n=devicePixelRatio;Re!=n&&(Re=n,Tu&&Rp(uy,Tu,Tp),Tu=matchMedia(`(min-resolution: ${Re-.001}dppx) and (max-resolution: ${Re+.001}dppx)`),oo(uy,Tu,Tp),ma.dispatchEvent(new CustomEvent(Iu)))}function Ci(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Cp(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function en(n,t,e){n.style[t]=e+"px"}function ns(n,t,e,i){let s=Ap.createElement(n);return t!=null&&Ci(s,t),e?.insertBefore(s,i),s}function Vi(n,t){return ns("div",n,t)}var dy=new WeakMap;function Ms(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=dy.get(n);r!=o&&(n.style.transform=r,dy.set(n,r),t<0||e<0||t>i||e>s?Ci(n,ro):Cp(n,ro))}var fy=new WeakMap;function py(n,t,e){let i=t+e,s=fy.get(n);i!=s&&(fy.set(n,i),n.style.background=t,n.style.borderColor=e)}var my=new WeakMap;function gy(n,t,e,i){let s=t+""+e,r=my.get(n);s!=r&&(my.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Bp={passive:!0},_P={...Bp,capture:!0};function oo(n,t,e,i){t.addEventListener(n,e,i?_P:Bp)}function Rp(n,t,e,i){t.removeEventListener(n,e,Bp)}va&&Tp();function is(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Ri((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Wy(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Xy=n=>n!=null,$y=n=>n!=null&&n>0,Nu=Wy(Xy),xP=Wy($y);function yP(n,t,e,i=0,s=!1){let r=s?xP:Nu,o=s?$y:Xy;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??We,l??-We]}function Ou(n,t,e,i){let s=yy(n),r=yy(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ks:Yy,a=s==1?Ri:Hi,l=r==1?Hi:Ri,c=a(o(Nn(n))),h=l(o(Nn(t))),d=ga(e,c),u=ga(e,h);return e==10&&(c<0&&(d=Xe(d,-c)),h<0&&(u=Xe(u,-h))),i||e==2?(n=d*s,t=u*r):(n=Jy(n,d),t=Uu(t,u)),[n,t]}function kp(n,t,e,i){let s=Ou(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var zp=.1,_y={mode:3,pad:zp},zl={pad:0,soft:null,mode:0},vP={min:zl,max:zl};function Lu(n,t,e,i){return Fu(e)?xy(n,t,e):(zl.pad=e,zl.soft=i?0:null,zl.mode=i?3:0,xy(n,t,vP))}function Ee(n,t){return n??t}function SP(n,t,e){for(t=Ee(t,0),e=Ee(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function xy(n,t,e){let i=e.min,s=e.max,r=Ee(i.pad,0),o=Ee(s.pad,0),a=Ee(i.hard,-We),l=Ee(s.hard,We),c=Ee(i.soft,We),h=Ee(s.soft,-We),d=Ee(i.mode,0),u=Ee(s.mode,0),f=t-n,p=Ks(f),_=ci(Nn(n),Nn(t)),m=Ks(_),g=Nn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,d==2&&c!=We&&(r=0),u==2&&h!=-We&&(o=0)));let x=f||_||1e3,b=Ks(x),v=ga(10,Ri(b)),C=x*(f==0?n==0?.1:1:r),E=Xe(Jy(n-C,v/10),24),y=n>=c&&(d==1||d==3&&E<=c||d==2&&E>=c)?c:We,w=ci(a,E<y&&n>=y?y:ss(y,E)),I=x*(f==0?t==0?.1:1:o),P=Xe(Uu(t+I,v/10),24),D=t<=h&&(u==1||u==3&&P>=h||u==2&&P<=h)?h:-We,F=ss(l,P>D&&t<=D?D:ci(D,P));return w==F&&w==0&&(F=100),[w,F]}var bP=new Intl.NumberFormat(va?gP.language:"en-US"),Gp=n=>bP.format(n),Pi=Math,Pu=Pi.PI,Nn=Pi.abs,Ri=Pi.floor,Dn=Pi.round,Hi=Pi.ceil,ss=Pi.min,ci=Pi.max,ga=Pi.pow,yy=Pi.sign,Ks=Pi.log10,Yy=Pi.log2,wP=(n,t=1)=>Pi.sinh(n)*t,bp=(n,t=1)=>Pi.asinh(n/t),We=1/0;function vy(n){return(Ks((n^n>>31)-(n>>31))|0)+1}function Pp(n,t,e){return ss(ci(n,t),e)}function qy(n){return typeof n=="function"}function Se(n){return qy(n)?n:()=>n}var MP=()=>{},Zy=n=>n,jy=(n,t)=>t,EP=n=>null,Sy=n=>!0,by=(n,t)=>n==t,AP=/\.\d*?(?=9{6,}|0{6,})/gm,ao=n=>{if(Qy(n)||Dr.has(n))return n;let t=`${n}`,e=t.match(AP);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ao(s)}e${r}`}return Xe(n,i)};function io(n,t){return ao(Xe(ao(n/t))*t)}function Uu(n,t){return ao(Hi(ao(n/t))*t)}function Jy(n,t){return ao(Ri(ao(n/t))*t)}function Xe(n,t=0){if(Qy(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Dn(i)/e}var Dr=new Map;function Ky(n){return((""+n).split(".")[1]||"").length}function Vl(n,t,e,i){let s=[],r=i.map(Ky);for(let o=t;o<e;o++){let a=Nn(o),l=Xe(ga(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),u=n==10?h:Xe(h,d);s.push(u),Dr.set(u,d)}}return s}var Gl={},Vp=[],_a=[null,null],Lr=Array.isArray,Qy=Number.isInteger,TP=n=>n===void 0;function wy(n){return typeof n=="string"}function Fu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function CP(n){return n!=null&&typeof n=="object"}var RP=Object.getPrototypeOf(Uint8Array),tv="__proto__";function xa(n,t=Fu){let e;if(Lr(n)){let i=n.find(s=>s!=null);if(Lr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=xa(n[s],t)}else e=n.slice()}else if(n instanceof RP)e=n.slice();else if(t(n)){e={};for(let i in n)i!=tv&&(e[i]=xa(n[i],t))}else e=n;return e}function Tn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=tv&&(Fu(n[s])?Tn(n[s],xa(i[s])):n[s]=xa(i[s]))}return n}var PP=0,IP=1,LP=2;function DP(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function NP(n,t){if(FP(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return BP(o[0])||(o=UP(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(s).fill(void 0),u=t?t[o][c]:IP,f=[];for(let p=0;p<h.length;p++){let _=h[p],m=r.get(l[p]);_===null?u!=PP&&(d[m]=_,u==LP&&f.push(m)):d[m]=_}DP(d,f,s),i.push(d)}}return i}var OP=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function UP(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function FP(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function BP(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ci(1,Ri((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ev=["January","February","March","April","May","June","July","August","September","October","November","December"],nv=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function iv(n){return n.slice(0,3)}var kP=nv.map(iv),zP=ev.map(iv),GP={MMMM:ev,MMM:zP,WWWW:nv,WWW:kP};function Ul(n){return(n<10?"0":"")+n}function VP(n){return(n<10?"00":n<100?"0":"")+n}var HP={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Ul(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ul(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Ul(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ul(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ul(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>VP(n.getMilliseconds())};function Hp(n,t){t=t||GP;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?HP[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var WP=new Intl.DateTimeFormat().resolvedOptions().timeZone;function XP(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==WP?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var sv=n=>n%1==0,Du=[1,2,2.5,5],$P=Vl(10,-32,0,Du),rv=Vl(10,0,32,Du),YP=rv.filter(sv),so=$P.concat(rv),Wp=`
`,ov="{YYYY}",My=Wp+ov,av="{M}/{D}",kl=Wp+av,Cu=kl+"/{YY}",lv="{aa}",qP="{h}:{mm}",pa=qP+lv,Ey=Wp+pa,Ay=":{ss}",Ne=null;function cv(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Vl(10,0,3,Du).filter(sv):Vl(10,-3,0,Du)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,ov,Ne,Ne,Ne,Ne,Ne,Ne,1],[s*28,"{MMM}",My,Ne,Ne,Ne,Ne,Ne,1],[s,av,My,Ne,Ne,Ne,Ne,Ne,1],[i,"{h}"+lv,Cu,Ne,kl,Ne,Ne,Ne,1],[e,pa,Cu,Ne,kl,Ne,Ne,Ne,1],[t,Ay,Cu+" "+pa,Ne,kl+" "+pa,Ne,Ey,Ne,1],[n,Ay+".{fff}",Cu+" "+pa,Ne,kl+" "+pa,Ne,Ey,Ne,1]];function h(d){return(u,f,p,_,m,g)=>{let x=[],b=m>=o,v=m>=r&&m<o,C=d(p),E=Xe(C*n,3),y=wp(C.getFullYear(),b?0:C.getMonth(),v||b?1:C.getDate()),w=Xe(y*n,3);if(v||b){let I=v?m/r:0,P=b?m/o:0,D=E==w?E:Xe(wp(y.getFullYear()+P,y.getMonth()+I,1)*n,3),F=new Date(Dn(D/n)),z=F.getFullYear(),O=F.getMonth();for(let G=0;D<=_;G++){let q=wp(z+P*G,O+I*G,1),V=q-d(Xe(q*n,3));D=Xe((+q+V)*n,3),D<=_&&x.push(D)}}else{let I=m>=s?s:m,P=Ri(p)-Ri(E),D=w+P+Uu(E-w,I);x.push(D);let F=d(D),z=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,O=m/i,G=u.axes[f]._space,q=g/G;for(;D=Xe(D+m,n==1?0:3),!(D>_);)if(O>1){let V=Ri(Xe(z+O,6))%24,K=d(D).getHours()-V;K>1&&(K=-1),D-=K*i,z=(z+O)%24;let et=x[x.length-1];Xe((D-et)/m,3)*q>=.7&&x.push(D)}else x.push(D)}return x}}return[l,c,h]}var[ZP,jP,JP]=cv(1),[KP,QP,tI]=cv(.001);Vl(2,-53,53,[1]);function Ty(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Cy(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,d,u,f;return i.map(p=>{let _=n(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),b=_.getHours(),v=_.getMinutes(),C=_.getSeconds(),E=m!=l&&a[2]||g!=c&&a[3]||x!=h&&a[4]||b!=d&&a[5]||v!=u&&a[6]||C!=f&&a[7]||a[1];return l=m,c=g,h=x,d=b,u=v,f=C,E(_)})}}function eI(n,t){let e=Hp(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function wp(n,t,e){return new Date(n,t,e)}function Ry(n,t){return t(n)}var nI="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Py(n,t){return(e,i,s,r)=>r==null?Fp:t(n(i))}function iI(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function sI(n,t){return n.series[t].fill(n,t)}var rI={show:!0,live:!0,isolate:!1,mount:MP,markers:{show:!0,width:2,stroke:iI,fill:sI,dash:"solid"},idx:null,idxs:null,values:[]};function oI(n,t){let e=n.cursor.points,i=Vi(),s=e.size(n,t);en(i,Fl,s),en(i,Bl,s);let r=s/-2;en(i,"marginLeft",r),en(i,"marginTop",r);let o=e.width(n,t,s);return o&&en(i,"borderWidth",o),i}function aI(n,t){let e=n.series[t].points;return e._fill||e._stroke}function lI(n,t){let e=n.series[t].points;return e._stroke||e._fill}function cI(n,t){return n.series[t].points.size}var Mp=[0,0];function hI(n,t,e){return Mp[0]=t,Mp[1]=e,Mp}function Ru(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Ep(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var uI={show:!0,x:!0,y:!0,lock:!1,move:hI,points:{one:!1,show:oI,size:cI,width:0,stroke:lI,fill:aI},bind:{mousedown:Ru,mouseup:Ru,click:Ru,dblclick:Ru,mousemove:Ep,mouseleave:Ep,mouseenter:Ep},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},hv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Xp=Tn({},hv,{filter:jy}),uv=Tn({},Xp,{size:10}),dv=Tn({},hv,{show:!1}),$p='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',fv="bold "+$p,pv=1.5,Iy={show:!0,scale:"x",stroke:Up,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fv,side:2,grid:Xp,ticks:uv,border:dv,font:$p,lineGap:pv,rotate:0},dI="Value",fI="Time",Ly={show:!0,scale:"x",auto:!1,sorted:1,min:We,max:-We,idxs:[]};function pI(n,t,e,i,s){return t.map(r=>r==null?"":Gp(r))}function mI(n,t,e,i,s,r,o){let a=[],l=Dr.get(s)||0;e=o?e:Xe(Uu(e,s),l);for(let c=e;c<=i;c=Xe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Ip(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ks:Yy,h=Ri(c(e));s=ga(l,h),l==10&&(s=so[is(s,so)]);let d=e,u=s*l;l==10&&(u=so[is(u,so)]);do a.push(d),d=d+s,l==10&&!Dr.has(d)&&(d=Xe(d,Dr.get(s))),d>=u&&(s=d,u=s*l,l==10&&(u=so[is(u,so)]));while(d<=i);return a}function gI(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Ip(n,t,ci(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?Ip(n,t,ci(l,-i),-e,s):[l]).reverse().map(u=>-u).concat(h,c)}var mv=/./,_I=/[12357]/,xI=/[125]/,Dy=/1/,Lp=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function yI(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),d=l(9,o)-h>=c?mv:l(7,o)-h>=c?_I:l(5,o)-h>=c?xI:Dy;if(d==Dy){let u=Nn(l(1,o)-h);if(u<c)return Lp(t.slice().reverse(),a.distr,d,Hi(c/u)).reverse()}return Lp(t,a.distr,d,1)}function vI(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Nn(l(1,o)-l(2,o));return c<a?Lp(t.slice().reverse(),3,mv,Hi(a/c)).reverse():t}function SI(n,t,e,i){return i==null?Fp:t==null?"":Gp(t)}var Ny={show:!0,scale:"y",stroke:Up,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:fv,side:3,grid:Xp,ticks:uv,border:dv,font:$p,lineGap:pv,rotate:0};function bI(n,t){let e=3+(n||1)*2;return Xe(e*t,3)}function wI(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Nn(o-r),l=n.series[t],c=a/(l.points.space*Re);return i[1]-i[0]<=c}var Oy={scale:null,auto:!0,sorted:0,min:We,max:-We},gv=(n,t,e,i,s)=>s,Uy={show:!0,auto:!0,sorted:0,gaps:gv,alpha:1,facets:[Tn({},Oy,{scale:"x"}),Tn({},Oy,{scale:"y"})]},Fy={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:gv,alpha:1,points:{show:wI,filter:null},values:null,min:We,max:-We,idxs:[],path:null,clip:null};function MI(n,t,e,i,s){return e/10}var _v={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},EI=Tn({},_v,{time:!1,ori:1}),By={};function xv(n,t){let e=By[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(By[n]=e)),e}var ya=1,Dp=2;function lo(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],u=a.left,f=a.top,p=a.width,_=a.height,m=n.valToPosH,g=n.valToPosV;return h.ori==0?e(s,l,c,h,d,m,g,u,f,p,_,ku,Sa,Gu,vv,bv):e(s,l,c,h,d,g,m,f,u,_,p,zu,ba,Zp,Sv,wv)}function Yp(n,t){let e=0,i=0,s=Ee(n.bands,Vp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function AI(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Qs(n,t,e,i,s,r){return lo(n,t,(o,a,l,c,h,d,u,f,p,_,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),b=c.ori==0?Sa:ba,v,C;x==1?(v=e,C=i):(v=i,C=e);let E=g(d(a[v],c,_,f)),y=g(u(l[v],h,m,p)),w=g(d(a[C],c,_,f)),I=g(u(r==1?h.max:h.min,h,m,p)),P=new Path2D(s);return b(P,w,I),b(P,E,I),b(P,E,y),P})}function Bu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Gu:Zp,l=e;for(let d=0;d<n.length;d++){let u=n[d];if(u[1]>u[0]){let f=u[0]-l;f>0&&a(o,l,i,f,i+r),l=u[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function TI(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function qp(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let d=c,u=c;if(s==1)for(;++c<=i&&t[c]===null;)u=c;else for(;--c>=e&&t[c]===null;)u=c;let f=r(n[d]),p=u==d?f:r(n[u]),_=d-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=u+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function ky(n){return n==0?Zy:n==1?Dn:t=>io(t,n)}function yv(n){let t=n==0?ku:zu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=ss(c,a/2,l/2),h=ss(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var ku=(n,t,e)=>{n.moveTo(t,e)},zu=(n,t,e)=>{n.moveTo(e,t)},Sa=(n,t,e)=>{n.lineTo(t,e)},ba=(n,t,e)=>{n.lineTo(e,t)},Gu=yv(0),Zp=yv(1),vv=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Sv=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},bv=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},wv=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Mv(n){return(t,e,i,s,r)=>lo(t,e,(o,a,l,c,h,d,u,f,p,_,m)=>{let{pxRound:g,points:x}=o,b,v;c.ori==0?(b=ku,v=vv):(b=zu,v=Sv);let C=Xe(x.width*Re,3),E=(x.size-x.width)/2*Re,y=Xe(E*2,3),w=new Path2D,I=new Path2D,{left:P,top:D,width:F,height:z}=t.bbox;Gu(I,P-y,D-y,F+y*2,z+y*2);let O=G=>{if(l[G]!=null){let q=g(d(a[G],c,_,f)),V=g(u(l[G],h,m,p));b(w,q+E,V),v(w,q,V,E,0,Pu*2)}};if(r)r.forEach(O);else for(let G=i;G<=s;G++)O(G);return{stroke:C>0?w:null,fill:w,clip:I,flags:ya|Dp}})}function Ev(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var CI=Ev(Sa),RI=Ev(ba);function Av(n){let t=Ee(n?.alignGaps,0);return(e,i,s,r)=>lo(e,i,(o,a,l,c,h,d,u,f,p,_,m)=>{[s,r]=Nu(l,s,r);let g=o.pxRound,x=z=>g(d(z,c,_,f)),b=z=>g(u(z,h,m,p)),v,C;c.ori==0?(v=Sa,C=CI):(v=ba,C=RI);let E=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ya},w=y.stroke,I=!1;if(r-s>=_*4){let z=ut=>e.posToVal(ut,c.key,!0),O=null,G=null,q,V,ot,$=x(a[E==1?s:r]),K=x(a[s]),et=x(a[r]),ht=z(E==1?K+1:et-1);for(let ut=E==1?s:r;ut>=s&&ut<=r;ut+=E){let Q=a[ut],yt=(E==1?Q<ht:Q>ht)?$:x(Q),Ct=l[ut];yt==$?Ct!=null?(V=Ct,O==null?(v(w,yt,b(V)),q=O=G=V):V<O?O=V:V>G&&(G=V)):Ct===null&&(I=!0):(O!=null&&C(w,$,b(O),b(G),b(q),b(V)),Ct!=null?(V=Ct,v(w,yt,b(V)),O=G=q=V):(O=G=null,Ct===null&&(I=!0)),$=yt,ht=z($+E))}O!=null&&O!=G&&ot!=$&&C(w,$,b(O),b(G),b(q),b(V))}else for(let z=E==1?s:r;z>=s&&z<=r;z+=E){let O=l[z];O===null?I=!0:O!=null&&v(w,x(a[z]),b(O))}let[D,F]=Yp(e,i);if(o.fill!=null||D!=0){let z=y.fill=new Path2D(w),O=o.fillTo(e,i,o.min,o.max,D),G=b(O),q=x(a[s]),V=x(a[r]);E==-1&&([V,q]=[q,V]),v(z,V,G),v(z,q,G)}if(!o.spanGaps){let z=[];I&&z.push(...qp(a,l,s,r,E,x,t)),y.gaps=z=o.gaps(e,i,s,r,z),y.clip=Bu(z,c.ori,f,p,_,m)}return F!=0&&(y.band=F==2?[Qs(e,i,s,r,w,-1),Qs(e,i,s,r,w,1)]:Qs(e,i,s,r,w,F)),y})}function PI(n){let t=Ee(n.align,1),e=Ee(n.ascDesc,!1),i=Ee(n.alignGaps,0),s=Ee(n.extend,!1);return(r,o,a,l)=>lo(r,o,(c,h,d,u,f,p,_,m,g,x,b)=>{[a,l]=Nu(d,a,l);let v=c.pxRound,{left:C,width:E}=r.bbox,y=K=>v(p(K,u,x,m)),w=K=>v(_(K,f,b,g)),I=u.ori==0?Sa:ba,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ya},D=P.stroke,F=u.dir*(u.ori==0?1:-1),z=w(d[F==1?a:l]),O=y(h[F==1?a:l]),G=O,q=O;s&&t==-1&&(q=C,I(D,q,z)),I(D,O,z);for(let K=F==1?a:l;K>=a&&K<=l;K+=F){let et=d[K];if(et==null)continue;let ht=y(h[K]),ut=w(et);t==1?I(D,ht,z):I(D,G,ut),I(D,ht,ut),z=ut,G=ht}let V=G;s&&t==1&&(V=C+E,I(D,V,z));let[ot,$]=Yp(r,o);if(c.fill!=null||ot!=0){let K=P.fill=new Path2D(D),et=c.fillTo(r,o,c.min,c.max,ot),ht=w(et);I(K,V,ht),I(K,q,ht)}if(!c.spanGaps){let K=[];K.push(...qp(h,d,a,l,F,y,i));let et=c.width*Re/2,ht=e||t==1?et:-et,ut=e||t==-1?-et:et;K.forEach(Q=>{Q[0]+=ht,Q[1]+=ut}),P.gaps=K=c.gaps(r,o,a,l,K),P.clip=Bu(K,u.ori,m,g,x,b)}return $!=0&&(P.band=$==2?[Qs(r,o,a,l,D,-1),Qs(r,o,a,l,D,1)]:Qs(r,o,a,l,D,$)),P})}function zy(n,t,e,i,s,r,o=We){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=Nn(n[l]-n[a]);h<c&&(c=h,o=Nn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function II(n){n=n||Gl;let t=Ee(n.size,[.6,We,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Se(s),o=1-t[0],a=Ee(t[1],We),l=Ee(t[2],1),c=Ee(n.disp,Gl),h=Ee(n.each,f=>{}),{fill:d,stroke:u}=c;return(f,p,_,m)=>lo(f,p,(g,x,b,v,C,E,y,w,I,P,D)=>{let F=g.pxRound,z=e,O=i*Re,G=a*Re,q=l*Re,V,ot;v.ori==0?[V,ot]=r(f,p):[ot,V]=r(f,p);let $=v.dir*(v.ori==0?1:-1),K=v.ori==0?Gu:Zp,et=v.ori==0?h:(Pt,jt,le,Mt,Ve,Gt,Yt)=>{h(Pt,jt,le,Ve,Mt,Yt,Gt)},ht=Ee(f.bands,Vp).find(Pt=>Pt.series[0]==p),ut=ht!=null?ht.dir:0,Q=g.fillTo(f,p,g.min,g.max,ut),gt=F(y(Q,C,D,I)),yt,Ct,wt,Wt=P,ae=F(g.width*Re),Vt=!1,me=null,ue=null,re=null,nn=null;d!=null&&(ae==0||u!=null)&&(Vt=!0,me=d.values(f,p,_,m),ue=new Map,new Set(me).forEach(Pt=>{Pt!=null&&ue.set(Pt,new Path2D)}),ae>0&&(re=u.values(f,p,_,m),nn=new Map,new Set(re).forEach(Pt=>{Pt!=null&&nn.set(Pt,new Path2D)})));let{x0:$e,size:vn}=c;if($e!=null&&vn!=null){z=1,x=$e.values(f,p,_,m),$e.unit==2&&(x=x.map(le=>f.posToVal(w+le*P,v.key,!0)));let Pt=vn.values(f,p,_,m);vn.unit==2?Ct=Pt[0]*P:Ct=E(Pt[0],v,P,w)-E(0,v,P,w),Wt=zy(x,b,E,v,P,w,Wt),wt=Wt-Ct+O}else Wt=zy(x,b,E,v,P,w,Wt),wt=Wt*o+O,Ct=Wt-wt;wt<1&&(wt=0),ae>=Ct/2&&(ae=0),wt<5&&(F=Zy);let ke=wt>0,On=Wt-wt-(ke?ae:0);Ct=F(Pp(On,q,G)),yt=(z==0?Ct/2:z==$?0:Ct)-z*$*((z==0?O/2:0)+(ke?ae/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Cn=Vt?null:new Path2D,dn=null;if(ht!=null)dn=f.data[ht.series[1]];else{let{y0:Pt,y1:jt}=c;Pt!=null&&jt!=null&&(b=jt.values(f,p,_,m),dn=Pt.values(f,p,_,m))}let Sn=V*Ct,k=ot*Ct;for(let Pt=$==1?_:m;Pt>=_&&Pt<=m;Pt+=$){let jt=b[Pt];if(jt==null)continue;if(dn!=null){let Y=dn[Pt]??0;if(jt-Y==0)continue;gt=y(Y,C,D,I)}let le=v.distr!=2||c!=null?x[Pt]:Pt,Mt=E(le,v,P,w),Ve=y(Ee(jt,Q),C,D,I),Gt=F(Mt-yt),Yt=F(ci(Ve,gt)),L=F(ss(Ve,gt)),M=Yt-L;if(jt!=null){let Y=jt<0?k:Sn,dt=jt<0?Sn:k;Vt?(ae>0&&re[Pt]!=null&&K(nn.get(re[Pt]),Gt,L+Ri(ae/2),Ct,ci(0,M-ae),Y,dt),me[Pt]!=null&&K(ue.get(me[Pt]),Gt,L+Ri(ae/2),Ct,ci(0,M-ae),Y,dt)):K(Cn,Gt,L+Ri(ae/2),Ct,ci(0,M-ae),Y,dt),et(f,p,Pt,Gt-ae/2,L,Ct+ae,M)}}return ae>0?be.stroke=Vt?nn:Cn:Vt||(be._fill=g.width==0?g._fill:g._stroke??g._fill,be.width=0),be.fill=Vt?ue:Cn,be})}function LI(n,t){let e=Ee(t?.alignGaps,0);return(i,s,r,o)=>lo(i,s,(a,l,c,h,d,u,f,p,_,m,g)=>{[r,o]=Nu(c,r,o);let x=a.pxRound,b=V=>x(u(V,h,m,p)),v=V=>x(f(V,d,g,_)),C,E,y;h.ori==0?(C=ku,y=Sa,E=bv):(C=zu,y=ba,E=wv);let w=h.dir*(h.ori==0?1:-1),I=b(l[w==1?r:o]),P=I,D=[],F=[];for(let V=w==1?r:o;V>=r&&V<=o;V+=w)if(c[V]!=null){let $=l[V],K=b($);D.push(P=K),F.push(v(c[V]))}let z={stroke:n(D,F,C,y,E,x),fill:null,clip:null,band:null,gaps:null,flags:ya},O=z.stroke,[G,q]=Yp(i,s);if(a.fill!=null||G!=0){let V=z.fill=new Path2D(O),ot=a.fillTo(i,s,a.min,a.max,G),$=v(ot);y(V,P,$),y(V,I,$)}if(!a.spanGaps){let V=[];V.push(...qp(l,c,r,o,w,b,e)),z.gaps=V=a.gaps(i,s,r,o,V),z.clip=Bu(V,h.ori,p,_,m,g)}return q!=0&&(z.band=q==2?[Qs(i,s,r,o,O,-1),Qs(i,s,r,o,O,1)]:Qs(i,s,r,o,O,q)),z})}function DI(n){return LI(NI,n)}function NI(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let u=0;u<o-1;u++)h[u]=t[u+1]-t[u],d[u]=n[u+1]-n[u],c[u]=h[u]/d[u];l[0]=c[0];for(let u=1;u<o-1;u++)c[u]===0||c[u-1]===0||c[u-1]>0!=c[u]>0?l[u]=0:(l[u]=3*(d[u-1]+d[u])/((2*d[u]+d[u-1])/c[u-1]+(d[u]+2*d[u-1])/c[u]),isFinite(l[u])||(l[u]=0));l[o-1]=c[o-2];for(let u=0;u<o-1;u++)s(a,n[u]+d[u]/3,t[u]+l[u]*d[u]/3,n[u+1]-d[u]/3,t[u+1]-l[u+1]*d[u]/3,n[u+1],t[u+1])}return a}var Np=new Set;function Gy(){for(let n of Np)n.syncRect(!0)}va&&(oo(pP,ma,Gy),oo(mP,ma,Gy,!0),oo(Iu,ma,()=>{Yn.pxRatio=Re}));var OI=Av(),UI=Mv();function Vy(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Op(r,o,t,e))}function FI(n,t){return n.map((e,i)=>i==0?{}:Tn({},t,e))}function Op(n,t,e,i){return Tn({},t==0?e:i,n)}function Tv(n,t,e){return t==null?_a:[t,e]}var BI=Tv;function kI(n,t,e){return t==null?_a:Lu(t,e,zp,!0)}function Cv(n,t,e,i){return t==null?_a:Ou(t,e,n.scales[i].log,!1)}var zI=Cv;function Rv(n,t,e,i){return t==null?_a:kp(t,e,n.scales[i].log,!1)}var GI=Rv;function VI(n,t,e,i,s){let r=ci(vy(n),vy(t)),o=t-n,a=is(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Dr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Hy(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Dn((e=+s)*Re))+"px"),[n,t,e]}function HI(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Xe(t[2]*Re,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Yn(n,t,e){let i={mode:Ee(n.mode,1)},s=i.mode;function r(S,A,N,U){let W=A.valToPct(S);return U+N*(A.dir==-1?1-W:W)}function o(S,A,N,U){let W=A.valToPct(S);return U+N*(A.dir==-1?W:1-W)}function a(S,A,N,U){return A.ori==0?r(S,A,N,U):o(S,A,N,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Vi(jR);if(n.id!=null&&(c.id=n.id),Ci(c,n.class),n.title){let S=Vi(QR,c);S.textContent=n.title}let h=ns("canvas"),d=i.ctx=h.getContext("2d"),u=Vi(tP,c);oo("click",u,S=>{S.target===p&&(je!=go||sn!=_o)&&Hn.click(i,S)},!0);let f=i.under=Vi(eP,u);u.appendChild(h);let p=i.over=Vi(nP,u);n=xa(n);let _=+Ee(n.pxAlign,1),m=ky(_);(n.plugins||[]).forEach(S=>{S.opts&&(n=S.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?Vy(n.series||[],Ly,Fy,!1):FI(n.series||[null],Uy),b=i.axes=Vy(n.axes||[],Iy,Ny,!0),v=i.scales={},C=i.bands=n.bands||[];C.forEach(S=>{S.fill=Se(S.fill||null),S.dir=Ee(S.dir,-1)});let E=s==2?x[1].facets[0].scale:x[0].scale,y={axes:Ps,series:_e},w=(n.drawOrder||["axes","series"]).map(S=>y[S]);function I(S){let A=S.distr==3?N=>Ks(N>0?N:S.clamp(i,N,S.min,S.max,S.key)):S.distr==4?N=>bp(N,S.asinh):S.distr==100?N=>S.fwd(N):N=>N;return N=>{let U=A(N),{_min:W,_max:J}=S,lt=J-W;return(U-W)/lt}}function P(S){let A=v[S];if(A==null){let N=(n.scales||Gl)[S]||Gl;if(N.from!=null){P(N.from);let U=Tn({},v[N.from],N,{key:S});U.valToPct=I(U),v[S]=U}else{A=v[S]=Tn({},S==E?_v:EI,N),A.key=S;let U=A.time,W=A.range,J=Lr(W);if((S!=E||s==2&&!U)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?_y:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?_y:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&Fu(W))){let lt=W;W=(ft,St,Nt)=>St==null?_a:Lu(St,Nt,lt)}A.range=Se(W||(U?BI:S==E?A.distr==3?zI:A.distr==4?GI:Tv:A.distr==3?Cv:A.distr==4?Rv:kI)),A.auto=Se(J?!1:A.auto),A.clamp=Se(A.clamp||MI),A._min=A._max=null,A.valToPct=I(A)}}}P("x"),P("y"),s==1&&x.forEach(S=>{P(S.scale)}),b.forEach(S=>{P(S.scale)});for(let S in n.scales)P(S);let D=v[E],F=D.distr,z,O;D.ori==0?(Ci(c,JR),z=r,O=o):(Ci(c,KR),z=o,O=r);let G={};for(let S in v){let A=v[S];(A.min!=null||A.max!=null)&&(G[S]={min:A.min,max:A.max},A.min=A.max=null)}let q=n.tzDate||(S=>new Date(Dn(S/g))),V=n.fmtDate||Hp,ot=g==1?JP(q):tI(q),$=Cy(q,Ty(g==1?jP:QP,V)),K=Py(q,Ry(nI,V)),et=[],ht=i.legend=Tn({},rI,n.legend),ut=i.cursor=Tn({},uI,{drag:{y:s==2}},n.cursor),Q=ht.show,gt=ut.show,yt=ht.markers;ht.idxs=et,yt.width=Se(yt.width),yt.dash=Se(yt.dash),yt.stroke=Se(yt.stroke),yt.fill=Se(yt.fill);let Ct,wt,Wt,ae=[],Vt=[],me,ue=!1,re={};if(ht.live){let S=x[1]?x[1].values:null;ue=S!=null,me=ue?S(i,1,0):{_:0};for(let A in me)re[A]=Fp}if(Q)if(Ct=ns("table",lP,c),Wt=ns("tbody",null,Ct),ht.mount(i,Ct),ue){wt=ns("thead",null,Ct,Wt);let S=ns("tr",null,wt);ns("th",null,S);for(var nn in me)ns("th",sy,S).textContent=nn}else Ci(Ct,hP),ht.live&&Ci(Ct,cP);let $e={show:!0},vn={show:!1};function ke(S,A){if(A==0&&(ue||!ht.live||s==2))return _a;let N=[],U=ns("tr",uP,Wt,Wt.childNodes[A]);Ci(U,S.class),S.show||Ci(U,ro);let W=ns("th",null,U);if(yt.show){let ft=Vi(dP,W);if(A>0){let St=yt.width(i,A);St&&(ft.style.border=St+"px "+yt.dash(i,A)+" "+yt.stroke(i,A)),ft.style.background=yt.fill(i,A)}}let J=Vi(sy,W);S.label instanceof HTMLElement?J.appendChild(S.label):J.textContent=S.label,A>0&&(yt.show||(J.style.color=S.width>0?yt.stroke(i,A):yt.fill(i,A)),be("click",W,ft=>{if(ut._lock)return;Qt(ft);let St=x.indexOf(S);if((ft.ctrlKey||ft.metaKey)!=ht.isolate){let Nt=x.some((Ot,Ft)=>Ft>0&&Ft!=St&&Ot.show);x.forEach((Ot,Ft)=>{Ft>0&&ls(Ft,Nt?Ft==St?$e:vn:$e,!0,En.setSeries)})}else ls(St,{show:!S.show},!0,En.setSeries)},!1),te&&be(ly,W,ft=>{ut._lock||(Qt(ft),ls(x.indexOf(S),yo,!0,En.setSeries))},!1));for(var lt in me){let ft=ns("td",fP,U);ft.textContent="--",N.push(ft)}return[U,N]}let On=new Map;function be(S,A,N,U=!0){let W=On.get(A)||{},J=ut.bind[S](i,A,N,U);J&&(oo(S,A,W[S]=J),On.set(A,W))}function Cn(S,A,N){let U=On.get(A)||{};for(let W in U)(S==null||W==S)&&(Rp(W,A,U[W]),delete U[W]);S==null&&On.delete(A)}let dn=0,Sn=0,k=0,Pt=0,jt=0,le=0,Mt=jt,Ve=le,Gt=k,Yt=Pt,L=0,M=0,Y=0,dt=0;i.bbox={};let at=!1,xt=!1,vt=!1,nt=!1,st=!1,pt=!1;function B(S,A,N){(N||S!=i.width||A!=i.height)&&rt(S,A),de(!1),vt=!0,xt=!0,qn()}function rt(S,A){i.width=dn=k=S,i.height=Sn=Pt=A,jt=le=0,bt(),Ht();let N=i.bbox;L=N.left=io(jt*Re,.5),M=N.top=io(le*Re,.5),Y=N.width=io(k*Re,.5),dt=N.height=io(Pt*Re,.5)}let it=3;function Et(){let S=!1,A=0;for(;!S;){A++;let N=fo(A),U=as(A);S=A==it||N&&U,S||(rt(i.width,i.height),xt=!0)}}function _t({width:S,height:A}){B(S,A)}i.setSize=_t;function bt(){let S=!1,A=!1,N=!1,U=!1;b.forEach((W,J)=>{if(W.show&&W._show){let{side:lt,_size:ft}=W,St=lt%2,Nt=W.label!=null?W.labelSize:0,Ot=ft+Nt;Ot>0&&(St?(k-=Ot,lt==3?(jt+=Ot,U=!0):N=!0):(Pt-=Ot,lt==0?(le+=Ot,S=!0):A=!0))}}),rs[0]=S,rs[1]=N,rs[2]=A,rs[3]=U,k-=Wi[1]+Wi[3],jt+=Wi[3],Pt-=Wi[2]+Wi[0],le+=Wi[0]}function Ht(){let S=jt+k,A=le+Pt,N=jt,U=le;function W(J,lt){switch(J){case 1:return S+=lt,S-lt;case 2:return A+=lt,A-lt;case 3:return N-=lt,N+lt;case 0:return U-=lt,U+lt}}b.forEach((J,lt)=>{if(J.show&&J._show){let ft=J.side;J._pos=W(ft,J._size),J.label!=null&&(J._lpos=W(ft,J.labelSize))}})}if(ut.dataIdx==null){let S=ut.hover,A=S.skip=new Set(S.skip??[]);A.add(void 0);let N=S.prox=Se(S.prox),U=S.bias??(S.bias=0);ut.dataIdx=(W,J,lt,ft)=>{if(J==0)return lt;let St=lt,Nt=N(W,J,lt,ft)??We,Ot=Nt>=0&&Nt<We,Ft=D.ori==0?k:Pt,oe=ut.left,Ae=t[0],we=t[J];if(A.has(we[lt])){St=null;let xe=null,Jt=null,Xt;if(U==0||U==-1)for(Xt=lt;xe==null&&Xt-- >0;)A.has(we[Xt])||(xe=Xt);if(U==0||U==1)for(Xt=lt;Jt==null&&Xt++<we.length;)A.has(we[Xt])||(Jt=Xt);if(xe!=null||Jt!=null)if(Ot){let Ke=xe==null?-1/0:z(Ae[xe],D,Ft,0),mn=Jt==null?1/0:z(Ae[Jt],D,Ft,0),kn=oe-Ke,ze=mn-oe;kn<=ze?kn<=Nt&&(St=xe):ze<=Nt&&(St=Jt)}else St=Jt==null?xe:xe==null?Jt:lt-xe<=Jt-lt?xe:Jt}else Ot&&Nn(oe-z(Ae[lt],D,Ft,0))>Nt&&(St=null);return St}}let Qt=S=>{ut.event=S};ut.idxs=et,ut._lock=!1;let ct=ut.points;ct.show=Se(ct.show),ct.size=Se(ct.size),ct.stroke=Se(ct.stroke),ct.width=Se(ct.width),ct.fill=Se(ct.fill);let Bt=i.focus=Tn({},n.focus||{alpha:.3},ut.focus),te=Bt.prox>=0,Rt=te&&ct.one,he=[],Ze=[],Qn=[];function wa(S,A){let N=ct.show(i,A);if(N instanceof HTMLElement)return Ci(N,aP),Ci(N,S.class),Ms(N,-10,-10,k,Pt),p.insertBefore(N,he[A]),N}function co(S,A){if(s==1||A>0){let N=s==1&&v[S.scale].time,U=S.value;S.value=N?wy(U)?Py(q,Ry(U,V)):U||K:U||SI,S.label=S.label||(N?fI:dI)}if(Rt||A>0){S.width=S.width==null?1:S.width,S.paths=S.paths||OI||EP,S.fillTo=Se(S.fillTo||AI),S.pxAlign=+Ee(S.pxAlign,_),S.pxRound=ky(S.pxAlign),S.stroke=Se(S.stroke||null),S.fill=Se(S.fill||null),S._stroke=S._fill=S._paths=S._focus=null;let N=bI(ci(1,S.width),1),U=S.points=Tn({},{size:N,width:ci(1,N*.2),stroke:S.stroke,space:N*2,paths:UI,_stroke:null,_fill:null},S.points);U.show=Se(U.show),U.filter=Se(U.filter),U.fill=Se(U.fill),U.stroke=Se(U.stroke),U.paths=Se(U.paths),U.pxAlign=S.pxAlign}if(Q){let N=ke(S,A);ae.splice(A,0,N[0]),Vt.splice(A,0,N[1]),ht.values.push(null)}if(gt){et.splice(A,0,null);let N=null;Rt?A==0&&(N=wa(S,A)):A>0&&(N=wa(S,A)),he.splice(A,0,N),Ze.splice(A,0,0),Qn.splice(A,0,0)}Bn("addSeries",A)}function Xu(S,A){A=A??x.length,S=s==1?Op(S,A,Ly,Fy):Op(S,A,{},Uy),x.splice(A,0,S),co(x[A],A)}i.addSeries=Xu;function Hl(S){if(x.splice(S,1),Q){ht.values.splice(S,1),Vt.splice(S,1);let A=ae.splice(S,1)[0];Cn(null,A.firstChild),A.remove()}gt&&(et.splice(S,1),he.splice(S,1)[0].remove(),Ze.splice(S,1),Qn.splice(S,1)),Bn("delSeries",S)}i.delSeries=Hl;let rs=[!1,!1,!1,!1];function Ts(S,A){if(S._show=S.show,S.show){let N=S.side%2,U=v[S.scale];U==null&&(S.scale=N?x[1].scale:E,U=v[S.scale]);let W=U.time;S.size=Se(S.size),S.space=Se(S.space),S.rotate=Se(S.rotate),Lr(S.incrs)&&S.incrs.forEach(lt=>{!Dr.has(lt)&&Dr.set(lt,Ky(lt))}),S.incrs=Se(S.incrs||(U.distr==2?YP:W?g==1?ZP:KP:so)),S.splits=Se(S.splits||(W&&U.distr==1?ot:U.distr==3?Ip:U.distr==4?gI:mI)),S.stroke=Se(S.stroke),S.grid.stroke=Se(S.grid.stroke),S.ticks.stroke=Se(S.ticks.stroke),S.border.stroke=Se(S.border.stroke);let J=S.values;S.values=Lr(J)&&!Lr(J[0])?Se(J):W?Lr(J)?Cy(q,Ty(J,V)):wy(J)?eI(q,J):J||$:J||pI,S.filter=Se(S.filter||(U.distr>=3&&U.log==10?yI:U.distr==3&&U.log==2?vI:jy)),S.font=Hy(S.font),S.labelFont=Hy(S.labelFont),S._size=S.size(i,null,A,0),S._space=S._rotate=S._incrs=S._found=S._splits=S._values=null,S._size>0&&(rs[A]=!0,S._el=Vi(iP,u))}}function Cs(S,A,N,U){let[W,J,lt,ft]=N,St=A%2,Nt=0;return St==0&&(ft||J)&&(Nt=A==0&&!W||A==2&&!lt?Dn(Iy.size/3):0),St==1&&(W||lt)&&(Nt=A==1&&!J||A==3&&!ft?Dn(Ny.size/2):0),Nt}let Ma=i.padding=(n.padding||[Cs,Cs,Cs,Cs]).map(S=>Se(Ee(S,Cs))),Wi=i._padding=Ma.map((S,A)=>S(i,A,rs,0)),fn,xn=null,yn=null,os=s==1?x[0].idxs:null,pi=null,tr=!1;function Ea(S,A){if(t=S??[],i.data=i._data=t,s==2){fn=0;for(let N=1;N<x.length;N++)fn+=t[N][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),pi=t[0],fn=pi.length;let N=t;if(F==2){N=t.slice();let U=N[0]=Array(fn);for(let W=0;W<fn;W++)U[W]=W}i._data=t=N}if(de(!0),Bn("setData"),F==2&&(vt=!0),A!==!1){let N=D;N.auto(i,tr)?Aa():ir(E,N.min,N.max),nt=nt||ut.left>=0,pt=!0,qn()}}i.setData=Ea;function Aa(){tr=!0;let S,A;s==1&&(fn>0?(xn=os[0]=0,yn=os[1]=fn-1,S=t[0][xn],A=t[0][yn],F==2?(S=xn,A=yn):S==A&&(F==3?[S,A]=Ou(S,S,D.log,!1):F==4?[S,A]=kp(S,S,D.log,!1):D.time?A=S+Dn(86400/g):[S,A]=Lu(S,A,zp,!0))):(xn=os[0]=S=null,yn=os[1]=A=null)),ir(E,S,A)}let ho,er,uo,T,H,tt,Z,j,At,Lt;function Tt(S,A,N,U,W,J){S??(S=oy),N??(N=Vp),U??(U="butt"),W??(W=oy),J??(J="round"),S!=ho&&(d.strokeStyle=ho=S),W!=er&&(d.fillStyle=er=W),A!=uo&&(d.lineWidth=uo=A),J!=H&&(d.lineJoin=H=J),U!=tt&&(d.lineCap=tt=U),N!=T&&d.setLineDash(T=N)}function Dt(S,A,N,U){A!=er&&(d.fillStyle=er=A),S!=Z&&(d.font=Z=S),N!=j&&(d.textAlign=j=N),U!=At&&(d.textBaseline=At=U)}function zt(S,A,N,U,W=0){if(U.length>0&&S.auto(i,tr)&&(A==null||A.min==null)){let J=Ee(xn,0),lt=Ee(yn,U.length-1),ft=N.min==null?yP(U,J,lt,W,S.distr==3):[N.min,N.max];S.min=ss(S.min,N.min=ft[0]),S.max=ci(S.max,N.max=ft[1])}}let ne={min:null,max:null};function ge(){for(let U in v){let W=v[U];G[U]==null&&(W.min==null||G[E]!=null&&W.auto(i,tr))&&(G[U]=ne)}for(let U in v){let W=v[U];G[U]==null&&W.from!=null&&G[W.from]!=null&&(G[U]=ne)}G[E]!=null&&de(!0);let S={};for(let U in G){let W=G[U];if(W!=null){let J=S[U]=xa(v[U],CP);if(W.min!=null)Tn(J,W);else if(U!=E||s==2)if(fn==0&&J.from==null){let lt=J.range(i,null,null,U);J.min=lt[0],J.max=lt[1]}else J.min=We,J.max=-We}}if(fn>0){x.forEach((U,W)=>{if(s==1){let J=U.scale,lt=G[J];if(lt==null)return;let ft=S[J];if(W==0){let St=ft.range(i,ft.min,ft.max,J);ft.min=St[0],ft.max=St[1],xn=is(ft.min,t[0]),yn=is(ft.max,t[0]),yn-xn>1&&(t[0][xn]<ft.min&&xn++,t[0][yn]>ft.max&&yn--),U.min=pi[xn],U.max=pi[yn]}else U.show&&U.auto&&zt(ft,lt,U,t[W],U.sorted);U.idxs[0]=xn,U.idxs[1]=yn}else if(W>0&&U.show&&U.auto){let[J,lt]=U.facets,ft=J.scale,St=lt.scale,[Nt,Ot]=t[W],Ft=S[ft],oe=S[St];Ft!=null&&zt(Ft,G[ft],J,Nt,J.sorted),oe!=null&&zt(oe,G[St],lt,Ot,lt.sorted),U.min=lt.min,U.max=lt.max}});for(let U in S){let W=S[U],J=G[U];if(W.from==null&&(J==null||J.min==null)){let lt=W.range(i,W.min==We?null:W.min,W.max==-We?null:W.max,U);W.min=lt[0],W.max=lt[1]}}}for(let U in S){let W=S[U];if(W.from!=null){let J=S[W.from];if(J.min==null)W.min=W.max=null;else{let lt=W.range(i,J.min,J.max,U);W.min=lt[0],W.max=lt[1]}}}let A={},N=!1;for(let U in S){let W=S[U],J=v[U];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let lt=J.distr;J._min=lt==3?Ks(J.min):lt==4?bp(J.min,J.asinh):lt==100?J.fwd(J.min):J.min,J._max=lt==3?Ks(J.max):lt==4?bp(J.max,J.asinh):lt==100?J.fwd(J.max):J.max,A[U]=N=!0}}if(N){x.forEach((U,W)=>{s==2?W>0&&A.y&&(U._paths=null):A[U.scale]&&(U._paths=null)});for(let U in A)vt=!0,Bn("setScale",U);gt&&ut.left>=0&&(nt=pt=!0)}for(let U in G)G[U]=null}function kt(S){let A=Pp(xn-1,0,fn-1),N=Pp(yn+1,0,fn-1);for(;S[A]==null&&A>0;)A--;for(;S[N]==null&&N<fn-1;)N++;return[A,N]}function _e(){if(fn>0){let S=x.some(A=>A._focus)&&Lt!=Bt.alpha;S&&(d.globalAlpha=Lt=Bt.alpha),x.forEach((A,N)=>{if(N>0&&A.show&&(ln(N,!1),ln(N,!0),A._paths==null)){let U=Lt;Lt!=A.alpha&&(d.globalAlpha=Lt=A.alpha);let W=s==2?[0,t[N][0].length-1]:kt(t[N]);A._paths=A.paths(i,N,W[0],W[1]),Lt!=U&&(d.globalAlpha=Lt=U)}}),x.forEach((A,N)=>{if(N>0&&A.show){let U=Lt;Lt!=A.alpha&&(d.globalAlpha=Lt=A.alpha),A._paths!=null&&Oe(N,!1);{let W=A._paths!=null?A._paths.gaps:null,J=A.points.show(i,N,xn,yn,W),lt=A.points.filter(i,N,J,W);(J||lt)&&(A.points._paths=A.points.paths(i,N,xn,yn,lt),Oe(N,!0))}Lt!=U&&(d.globalAlpha=Lt=U),Bn("drawSeries",N)}}),S&&(d.globalAlpha=Lt=1)}}function ln(S,A){let N=A?x[S].points:x[S];N._stroke=N.stroke(i,S),N._fill=N.fill(i,S)}function Oe(S,A){let N=A?x[S].points:x[S],{stroke:U,fill:W,clip:J,flags:lt,_stroke:ft=N._stroke,_fill:St=N._fill,_width:Nt=N.width}=N._paths;Nt=Xe(Nt*Re,3);let Ot=null,Ft=Nt%2/2;A&&St==null&&(St=Nt>0?"#fff":ft);let oe=N.pxAlign==1&&Ft>0;if(oe&&d.translate(Ft,Ft),!A){let Ae=L-Nt/2,we=M-Nt/2,xe=Y+Nt,Jt=dt+Nt;Ot=new Path2D,Ot.rect(Ae,we,xe,Jt)}A?Ut(ft,Nt,N.dash,N.cap,St,U,W,lt,J):Ue(S,ft,Nt,N.dash,N.cap,St,U,W,lt,Ot,J),oe&&d.translate(-Ft,-Ft)}function Ue(S,A,N,U,W,J,lt,ft,St,Nt,Ot){let Ft=!1;St!=0&&C.forEach((oe,Ae)=>{if(oe.series[0]==S){let we=x[oe.series[1]],xe=t[oe.series[1]],Jt=(we._paths||Gl).band;Lr(Jt)&&(Jt=oe.dir==1?Jt[0]:Jt[1]);let Xt,Ke=null;we.show&&Jt&&SP(xe,xn,yn)?(Ke=oe.fill(i,Ae)||J,Xt=we._paths.clip):Jt=null,Ut(A,N,U,W,Ke,lt,ft,St,Nt,Ot,Xt,Jt),Ft=!0}}),Ft||Ut(A,N,U,W,J,lt,ft,St,Nt,Ot)}let Rn=ya|Dp;function Ut(S,A,N,U,W,J,lt,ft,St,Nt,Ot,Ft){Tt(S,A,N,U,W),(St||Nt||Ft)&&(d.save(),St&&d.clip(St),Nt&&d.clip(Nt)),Ft?(ft&Rn)==Rn?(d.clip(Ft),Ot&&d.clip(Ot),ye(W,lt),bn(S,J,A)):ft&Dp?(ye(W,lt),d.clip(Ft),bn(S,J,A)):ft&ya&&(d.save(),d.clip(Ft),Ot&&d.clip(Ot),ye(W,lt),d.restore(),bn(S,J,A)):(ye(W,lt),bn(S,J,A)),(St||Nt||Ft)&&d.restore()}function bn(S,A,N){N>0&&(A instanceof Map?A.forEach((U,W)=>{d.strokeStyle=ho=W,d.stroke(U)}):A!=null&&S&&d.stroke(A))}function ye(S,A){A instanceof Map?A.forEach((N,U)=>{d.fillStyle=er=U,d.fill(N)}):A!=null&&S&&d.fill(A)}function Rs(S,A,N,U){let W=b[S],J;if(U<=0)J=[0,0];else{let lt=W._space=W.space(i,S,A,N,U),ft=W._incrs=W.incrs(i,S,A,N,U,lt);J=VI(A,N,ft,U,lt)}return W._found=J}function wn(S,A,N,U,W,J,lt,ft,St,Nt){let Ot=lt%2/2;_==1&&d.translate(Ot,Ot),Tt(ft,lt,St,Nt,ft),d.beginPath();let Ft,oe,Ae,we,xe=W+(U==0||U==3?-J:J);N==0?(oe=W,we=xe):(Ft=W,Ae=xe);for(let Jt=0;Jt<S.length;Jt++)A[Jt]!=null&&(N==0?Ft=Ae=S[Jt]:oe=we=S[Jt],d.moveTo(Ft,oe),d.lineTo(Ae,we));d.stroke(),_==1&&d.translate(-Ot,-Ot)}function fo(S){let A=!0;return b.forEach((N,U)=>{if(!N.show)return;let W=v[N.scale];if(W.min==null){N._show&&(A=!1,N._show=!1,de(!1));return}else N._show||(A=!1,N._show=!0,de(!1));let J=N.side,lt=J%2,{min:ft,max:St}=W,[Nt,Ot]=Rs(U,ft,St,lt==0?k:Pt);if(Ot==0)return;let Ft=W.distr==2,oe=N._splits=N.splits(i,U,ft,St,Nt,Ot,Ft),Ae=W.distr==2?oe.map(Xt=>pi[Xt]):oe,we=W.distr==2?pi[oe[1]]-pi[oe[0]]:Nt,xe=N._values=N.values(i,N.filter(i,Ae,U,Ot,we),U,Ot,we);N._rotate=J==2?N.rotate(i,xe,U,Ot):0;let Jt=N._size;N._size=Hi(N.size(i,xe,U,S)),Jt!=null&&N._size!=Jt&&(A=!1)}),A}function as(S){let A=!0;return Ma.forEach((N,U)=>{let W=N(i,U,rs,S);W!=Wi[U]&&(A=!1),Wi[U]=W}),A}function Ps(){for(let S=0;S<b.length;S++){let A=b[S];if(!A.show||!A._show)continue;let N=A.side,U=N%2,W,J,lt=A.stroke(i,S),ft=N==0||N==3?-1:1,[St,Nt]=A._found;if(A.label!=null){let ni=A.labelGap*ft,_i=Dn((A._lpos+ni)*Re);Dt(A.labelFont[0],lt,"center",N==2?"top":ry),d.save(),U==1?(W=J=0,d.translate(_i,Dn(M+dt/2)),d.rotate((N==3?-Pu:Pu)/2)):(W=Dn(L+Y/2),J=_i);let Ur=qy(A.label)?A.label(i,S,St,Nt):A.label;d.fillText(Ur,W,J),d.restore()}if(Nt==0)continue;let Ot=v[A.scale],Ft=U==0?Y:dt,oe=U==0?L:M,Ae=A._splits,we=Ot.distr==2?Ae.map(ni=>pi[ni]):Ae,xe=Ot.distr==2?pi[Ae[1]]-pi[Ae[0]]:St,Jt=A.ticks,Xt=A.border,Ke=Jt.show?Jt.size:0,mn=Dn(Ke*Re),kn=Dn((A.alignTo==2?A._size-Ke-A.gap:A.gap)*Re),ze=A._rotate*-Pu/180,gn=m(A._pos*Re),mi=(mn+kn)*ft,ei=gn+mi;J=U==0?ei:0,W=U==1?ei:0;let Ii=A.font[0],Xi=A.align==1?fa:A.align==2?yp:ze>0?fa:ze<0?yp:U==0?"center":N==3?yp:fa,hs=ze||U==1?"middle":N==2?"top":ry;Dt(Ii,lt,Xi,hs);let gi=A.font[1]*A.lineGap,Li=Ae.map(ni=>m(a(ni,Ot,Ft,oe))),$i=A._values;for(let ni=0;ni<$i.length;ni++){let _i=$i[ni];if(_i!=null){U==0?W=Li[ni]:J=Li[ni],_i=""+_i;let Ur=_i.indexOf(`
`)==-1?[_i]:_i.split(/\n/gm);for(let ii=0;ii<Ur.length;ii++){let bm=Ur[ii];ze?(d.save(),d.translate(W,J+ii*gi),d.rotate(ze),d.fillText(bm,0,0),d.restore()):d.fillText(bm,W,J+ii*gi)}}}Jt.show&&wn(Li,Jt.filter(i,we,S,Nt,xe),U,N,gn,mn,Xe(Jt.width*Re,3),Jt.stroke(i,S),Jt.dash,Jt.cap);let us=A.grid;us.show&&wn(Li,us.filter(i,we,S,Nt,xe),U,U==0?2:1,U==0?M:L,U==0?dt:Y,Xe(us.width*Re,3),us.stroke(i,S),us.dash,us.cap),Xt.show&&wn([gn],[1],U==0?1:0,U==0?1:2,U==1?M:L,U==1?dt:Y,Xe(Xt.width*Re,3),Xt.stroke(i,S),Xt.dash,Xt.cap)}Bn("drawAxes")}function de(S){x.forEach((A,N)=>{N>0&&(A._paths=null,S&&(s==1?(A.min=null,A.max=null):A.facets.forEach(U=>{U.min=null,U.max=null})))})}let pn=!1,ti=!1,Fe=[];function Mn(){ti=!1;for(let S=0;S<Fe.length;S++)Bn(...Fe[S]);Fe.length=0}function qn(){pn||(OP(sm),pn=!0)}function Wl(S,A=!1){pn=!0,ti=A,S(i),sm(),A&&Fe.length>0&&queueMicrotask(Mn)}i.batch=Wl;function sm(){if(at&&(ge(),at=!1),vt&&(Et(),vt=!1),xt){if(en(f,fa,jt),en(f,"top",le),en(f,Fl,k),en(f,Bl,Pt),en(p,fa,jt),en(p,"top",le),en(p,Fl,k),en(p,Bl,Pt),en(u,Fl,dn),en(u,Bl,Sn),h.width=Dn(dn*Re),h.height=Dn(Sn*Re),b.forEach(({_el:S,_show:A,_size:N,_pos:U,side:W})=>{if(S!=null)if(A){let J=W===3||W===0?N:0,lt=W%2==1;en(S,lt?"left":"top",U-J),en(S,lt?"width":"height",N),en(S,lt?"top":"left",lt?le:jt),en(S,lt?"height":"width",lt?Pt:k),Cp(S,ro)}else Ci(S,ro)}),ho=er=uo=H=tt=Z=j=At=T=null,Lt=1,Ra(!0),jt!=Mt||le!=Ve||k!=Gt||Pt!=Yt){de(!1);let S=k/Gt,A=Pt/Yt;if(gt&&!nt&&ut.left>=0){ut.left*=S,ut.top*=A,po&&Ms(po,Dn(ut.left),0,k,Pt),mo&&Ms(mo,0,Dn(ut.top),k,Pt);for(let N=0;N<he.length;N++){let U=he[N];U!=null&&(Ze[N]*=S,Qn[N]*=A,Ms(U,Hi(Ze[N]),Hi(Qn[N]),k,Pt))}}if(Je.show&&!st&&Je.left>=0&&Je.width>0){Je.left*=S,Je.width*=S,Je.top*=A,Je.height*=A;for(let N in Ju)en(xo,N,Je[N])}Mt=jt,Ve=le,Gt=k,Yt=Pt}Bn("setSize"),xt=!1}dn>0&&Sn>0&&(d.clearRect(0,0,h.width,h.height),Bn("drawClear"),w.forEach(S=>S()),Bn("draw")),Je.show&&st&&(Xl(Je),st=!1),gt&&nt&&(Or(null,!0,!1),nt=!1),ht.show&&ht.live&&pt&&(Zu(),pt=!1),l||(l=!0,i.status=1,Bn("ready")),tr=!1,pn=!1}i.redraw=(S,A)=>{vt=A||!1,S!==!1?ir(E,D.min,D.max):qn()};function $u(S,A){let N=v[S];if(N.from==null){if(fn==0){let U=N.range(i,A.min,A.max,S);A.min=U[0],A.max=U[1]}if(A.min>A.max){let U=A.min;A.min=A.max,A.max=U}if(fn>1&&A.min!=null&&A.max!=null&&A.max-A.min<1e-16)return;S==E&&N.distr==2&&fn>0&&(A.min=is(A.min,t[0]),A.max=is(A.max,t[0]),A.min==A.max&&A.max++),G[S]=A,at=!0,qn()}}i.setScale=$u;let Yu,qu,po,mo,rm,om,go,_o,am,lm,je,sn,nr=!1,Hn=ut.drag,Un=Hn.x,Fn=Hn.y;gt&&(ut.x&&(Yu=Vi(rP,p)),ut.y&&(qu=Vi(oP,p)),D.ori==0?(po=Yu,mo=qu):(po=qu,mo=Yu),je=ut.left,sn=ut.top);let Je=i.select=Tn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),xo=Je.show?Vi(sP,Je.over?p:f):null;function Xl(S,A){if(Je.show){for(let N in S)Je[N]=S[N],N in Ju&&en(xo,N,S[N]);A!==!1&&Bn("setSelect")}}i.setSelect=Xl;function mS(S){if(x[S].show)Q&&Cp(ae[S],ro);else if(Q&&Ci(ae[S],ro),gt){let N=Rt?he[0]:he[S];N!=null&&Ms(N,-10,-10,k,Pt)}}function ir(S,A,N){$u(S,{min:A,max:N})}function ls(S,A,N,U){A.focus!=null&&vS(S),A.show!=null&&x.forEach((W,J)=>{J>0&&(S==J||S==null)&&(W.show=A.show,mS(J),s==2?(ir(W.facets[0].scale,null,null),ir(W.facets[1].scale,null,null)):ir(W.scale,null,null),qn())}),N!==!1&&Bn("setSeries",S,A),U&&Pa("setSeries",i,S,A)}i.setSeries=ls;function gS(S,A){Tn(C[S],A)}function _S(S,A){S.fill=Se(S.fill||null),S.dir=Ee(S.dir,-1),A=A??C.length,C.splice(A,0,S)}function xS(S){S==null?C.length=0:C.splice(S,1)}i.addBand=_S,i.setBand=gS,i.delBand=xS;function yS(S,A){x[S].alpha=A,gt&&he[S]!=null&&(he[S].style.opacity=A),Q&&ae[S]&&(ae[S].style.opacity=A)}let Is,sr,Nr,yo={focus:!0};function vS(S){if(S!=Nr){let A=S==null,N=Bt.alpha!=1;x.forEach((U,W)=>{if(s==1||W>0){let J=A||W==0||W==S;U._focus=A?null:J,N&&yS(W,J?1:Bt.alpha)}}),Nr=S,N&&qn()}}Q&&te&&be(cy,Ct,S=>{ut._lock||(Qt(S),Nr!=null&&ls(null,yo,!0,En.setSeries))});function cs(S,A,N){let U=v[A];N&&(S=S/Re-(U.ori==1?le:jt));let W=k;U.ori==1&&(W=Pt,S=W-S),U.dir==-1&&(S=W-S);let J=U._min,lt=U._max,ft=S/W,St=J+(lt-J)*ft,Nt=U.distr;return Nt==3?ga(10,St):Nt==4?wP(St,U.asinh):Nt==100?U.bwd(St):St}function SS(S,A){let N=cs(S,E,A);return is(N,t[0],xn,yn)}i.valToIdx=S=>is(S,t[0]),i.posToIdx=SS,i.posToVal=cs,i.valToPos=(S,A,N)=>v[A].ori==0?r(S,v[A],N?Y:k,N?L:0):o(S,v[A],N?dt:Pt,N?M:0),i.setCursor=(S,A,N)=>{je=S.left,sn=S.top,Or(null,A,N)};function cm(S,A){en(xo,fa,Je.left=S),en(xo,Fl,Je.width=A)}function hm(S,A){en(xo,"top",Je.top=S),en(xo,Bl,Je.height=A)}let Ta=D.ori==0?cm:hm,Ca=D.ori==1?cm:hm;function bS(){if(Q&&ht.live)for(let S=s==2?1:0;S<x.length;S++){if(S==0&&ue)continue;let A=ht.values[S],N=0;for(let U in A)Vt[S][N++].firstChild.nodeValue=A[U]}}function Zu(S,A){if(S!=null&&(S.idxs?S.idxs.forEach((N,U)=>{et[U]=N}):TP(S.idx)||et.fill(S.idx),ht.idx=et[0]),Q&&ht.live){for(let N=0;N<x.length;N++)(N>0||s==1&&!ue)&&wS(N,et[N]);bS()}pt=!1,A!==!1&&Bn("setLegend")}i.setLegend=Zu;function wS(S,A){let N=x[S],U=S==0&&F==2?pi:t[S],W;ue?W=N.values(i,S,A)??re:(W=N.value(i,A==null?null:U[A],S,A),W=W==null?re:{_:W}),ht.values[S]=W}function Or(S,A,N){am=je,lm=sn,[je,sn]=ut.move(i,je,sn),ut.left=je,ut.top=sn,gt&&(po&&Ms(po,Dn(je),0,k,Pt),mo&&Ms(mo,0,Dn(sn),k,Pt));let U,W=xn>yn;Is=We,sr=null;let J=D.ori==0?k:Pt,lt=D.ori==1?k:Pt;if(je<0||fn==0||W){U=ut.idx=null;for(let ft=0;ft<x.length;ft++){let St=he[ft];St!=null&&Ms(St,-10,-10,k,Pt)}te&&ls(null,yo,!0,S==null&&En.setSeries),ht.live&&(et.fill(U),pt=!0)}else{let ft,St,Nt;s==1&&(ft=D.ori==0?je:sn,St=cs(ft,E),U=ut.idx=is(St,t[0],xn,yn),Nt=z(t[0][U],D,J,0));let Ot=-10,Ft=-10,oe=0,Ae=0,we=!0,xe="",Jt="";for(let Xt=s==2?1:0;Xt<x.length;Xt++){let Ke=x[Xt],mn=et[Xt],kn=mn==null?null:s==1?t[Xt][mn]:t[Xt][1][mn],ze=ut.dataIdx(i,Xt,U,St),gn=ze==null?null:s==1?t[Xt][ze]:t[Xt][1][ze];if(pt=pt||gn!=kn||ze!=mn,et[Xt]=ze,Xt>0&&Ke.show){let mi=ze==null?-10:ze==U?Nt:z(s==1?t[0][ze]:t[Xt][0][ze],D,J,0),ei=gn==null?-10:O(gn,s==1?v[Ke.scale]:v[Ke.facets[1].scale],lt,0);if(te&&gn!=null){let Ii=D.ori==1?je:sn,Xi=Nn(Bt.dist(i,Xt,ze,ei,Ii));if(Xi<Is){let hs=Bt.bias;if(hs!=0){let gi=cs(Ii,Ke.scale),Li=gn>=0?1:-1,$i=gi>=0?1:-1;$i==Li&&($i==1?hs==1?gn>=gi:gn<=gi:hs==1?gn<=gi:gn>=gi)&&(Is=Xi,sr=Xt)}else Is=Xi,sr=Xt}}if(pt||Rt){let Ii,Xi;D.ori==0?(Ii=mi,Xi=ei):(Ii=ei,Xi=mi);let hs,gi,Li,$i,us,ni,_i=!0,Ur=ct.bbox;if(Ur!=null){_i=!1;let ii=Ur(i,Xt);Li=ii.left,$i=ii.top,hs=ii.width,gi=ii.height}else Li=Ii,$i=Xi,hs=gi=ct.size(i,Xt);if(ni=ct.fill(i,Xt),us=ct.stroke(i,Xt),Rt)Xt==sr&&Is<=Bt.prox&&(Ot=Li,Ft=$i,oe=hs,Ae=gi,we=_i,xe=ni,Jt=us);else{let ii=he[Xt];ii!=null&&(Ze[Xt]=Li,Qn[Xt]=$i,gy(ii,hs,gi,_i),py(ii,ni,us),Ms(ii,Hi(Li),Hi($i),k,Pt))}}}}if(Rt){let Xt=Bt.prox,Ke=Nr==null?Is<=Xt:Is>Xt||sr!=Nr;if(pt||Ke){let mn=he[0];mn!=null&&(Ze[0]=Ot,Qn[0]=Ft,gy(mn,oe,Ae,we),py(mn,xe,Jt),Ms(mn,Hi(Ot),Hi(Ft),k,Pt))}}}if(Je.show&&nr)if(S!=null){let[ft,St]=En.scales,[Nt,Ot]=En.match,[Ft,oe]=S.cursor.sync.scales,Ae=S.cursor.drag;if(Un=Ae._x,Fn=Ae._y,Un||Fn){let{left:we,top:xe,width:Jt,height:Xt}=S.select,Ke=S.scales[Ft].ori,mn=S.posToVal,kn,ze,gn,mi,ei,Ii=ft!=null&&Nt(ft,Ft),Xi=St!=null&&Ot(St,oe);Ii&&Un?(Ke==0?(kn=we,ze=Jt):(kn=xe,ze=Xt),gn=v[ft],mi=z(mn(kn,Ft),gn,J,0),ei=z(mn(kn+ze,Ft),gn,J,0),Ta(ss(mi,ei),Nn(ei-mi))):Ta(0,J),Xi&&Fn?(Ke==1?(kn=we,ze=Jt):(kn=xe,ze=Xt),gn=v[St],mi=O(mn(kn,oe),gn,lt,0),ei=O(mn(kn+ze,oe),gn,lt,0),Ca(ss(mi,ei),Nn(ei-mi))):Ca(0,lt)}else Ku()}else{let ft=Nn(am-rm),St=Nn(lm-om);if(D.ori==1){let oe=ft;ft=St,St=oe}Un=Hn.x&&ft>=Hn.dist,Fn=Hn.y&&St>=Hn.dist;let Nt=Hn.uni;Nt!=null?Un&&Fn&&(Un=ft>=Nt,Fn=St>=Nt,!Un&&!Fn&&(St>ft?Fn=!0:Un=!0)):Hn.x&&Hn.y&&(Un||Fn)&&(Un=Fn=!0);let Ot,Ft;Un&&(D.ori==0?(Ot=go,Ft=je):(Ot=_o,Ft=sn),Ta(ss(Ot,Ft),Nn(Ft-Ot)),Fn||Ca(0,lt)),Fn&&(D.ori==1?(Ot=go,Ft=je):(Ot=_o,Ft=sn),Ca(ss(Ot,Ft),Nn(Ft-Ot)),Un||Ta(0,J)),!Un&&!Fn&&(Ta(0,0),Ca(0,0))}if(Hn._x=Un,Hn._y=Fn,S==null){if(N){if(Sm!=null){let[ft,St]=En.scales;En.values[0]=ft!=null?cs(D.ori==0?je:sn,ft):null,En.values[1]=St!=null?cs(D.ori==1?je:sn,St):null}Pa(vp,i,je,sn,k,Pt,U)}if(te){let ft=N&&En.setSeries,St=Bt.prox;Nr==null?Is<=St&&ls(sr,yo,!0,ft):Is>St?ls(null,yo,!0,ft):sr!=Nr&&ls(sr,yo,!0,ft)}}pt&&(ht.idx=U,Zu()),A!==!1&&Bn("setCursor")}let rr=null;Object.defineProperty(i,"rect",{get(){return rr==null&&Ra(!1),rr}});function Ra(S=!1){S?rr=null:(rr=p.getBoundingClientRect(),Bn("syncRect",rr))}function um(S,A,N,U,W,J,lt){ut._lock||nr&&S!=null&&S.movementX==0&&S.movementY==0||(ju(S,A,N,U,W,J,lt,!1,S!=null),S!=null?Or(null,!0,!0):Or(A,!0,!1))}function ju(S,A,N,U,W,J,lt,ft,St){if(rr==null&&Ra(!1),Qt(S),S!=null)N=S.clientX-rr.left,U=S.clientY-rr.top;else{if(N<0||U<0){je=-10,sn=-10;return}let[Nt,Ot]=En.scales,Ft=A.cursor.sync,[oe,Ae]=Ft.values,[we,xe]=Ft.scales,[Jt,Xt]=En.match,Ke=A.axes[0].side%2==1,mn=D.ori==0?k:Pt,kn=D.ori==1?k:Pt,ze=Ke?J:W,gn=Ke?W:J,mi=Ke?U:N,ei=Ke?N:U;if(we!=null?N=Jt(Nt,we)?a(oe,v[Nt],mn,0):-10:N=mn*(mi/ze),xe!=null?U=Xt(Ot,xe)?a(Ae,v[Ot],kn,0):-10:U=kn*(ei/gn),D.ori==1){let Ii=N;N=U,U=Ii}}St&&(A==null||A.cursor.event.type==vp)&&((N<=1||N>=k-1)&&(N=io(N,k)),(U<=1||U>=Pt-1)&&(U=io(U,Pt))),ft?(rm=N,om=U,[go,_o]=ut.move(i,N,U)):(je=N,sn=U)}let Ju={width:0,height:0,left:0,top:0};function Ku(){Xl(Ju,!1)}let dm,fm,pm,mm;function gm(S,A,N,U,W,J,lt){nr=!0,Un=Fn=Hn._x=Hn._y=!1,ju(S,A,N,U,W,J,lt,!0,!1),S!=null&&(be(Sp,Ap,_m,!1),Pa(ay,i,go,_o,k,Pt,null));let{left:ft,top:St,width:Nt,height:Ot}=Je;dm=ft,fm=St,pm=Nt,mm=Ot}function _m(S,A,N,U,W,J,lt){nr=Hn._x=Hn._y=!1,ju(S,A,N,U,W,J,lt,!1,!0);let{left:ft,top:St,width:Nt,height:Ot}=Je,Ft=Nt>0||Ot>0,oe=dm!=ft||fm!=St||pm!=Nt||mm!=Ot;if(Ft&&oe&&Xl(Je),Hn.setScale&&Ft&&oe){let Ae=ft,we=Nt,xe=St,Jt=Ot;if(D.ori==1&&(Ae=St,we=Ot,xe=ft,Jt=Nt),Un&&ir(E,cs(Ae,E),cs(Ae+we,E)),Fn)for(let Xt in v){let Ke=v[Xt];Xt!=E&&Ke.from==null&&Ke.min!=We&&ir(Xt,cs(xe+Jt,Xt),cs(xe,Xt))}Ku()}else ut.lock&&(ut._lock=!ut._lock,Or(A,!0,S!=null));S!=null&&(Cn(Sp,Ap),Pa(Sp,i,je,sn,k,Pt,null))}function MS(S,A,N,U,W,J,lt){if(ut._lock)return;Qt(S);let ft=nr;if(nr){let St=!0,Nt=!0,Ot=10,Ft,oe;D.ori==0?(Ft=Un,oe=Fn):(Ft=Fn,oe=Un),Ft&&oe&&(St=je<=Ot||je>=k-Ot,Nt=sn<=Ot||sn>=Pt-Ot),Ft&&St&&(je=je<go?0:k),oe&&Nt&&(sn=sn<_o?0:Pt),Or(null,!0,!0),nr=!1}je=-10,sn=-10,et.fill(null),Or(null,!0,!0),ft&&(nr=ft)}function xm(S,A,N,U,W,J,lt){ut._lock||(Qt(S),Aa(),Ku(),S!=null&&Pa(hy,i,je,sn,k,Pt,null))}function ym(){b.forEach(HI),B(i.width,i.height,!0)}oo(Iu,ma,ym);let vo={};vo.mousedown=gm,vo.mousemove=um,vo.mouseup=_m,vo.dblclick=xm,vo.setSeries=(S,A,N,U)=>{let W=En.match[2];N=W(i,A,N),N!=-1&&ls(N,U,!0,!1)},gt&&(be(ay,p,gm),be(vp,p,um),be(ly,p,S=>{Qt(S),Ra(!1)}),be(cy,p,MS),be(hy,p,xm),Np.add(i),i.syncRect=Ra);let $l=i.hooks=n.hooks||{};function Bn(S,A,N){ti?Fe.push([S,A,N]):S in $l&&$l[S].forEach(U=>{U.call(null,i,A,N)})}(n.plugins||[]).forEach(S=>{for(let A in S.hooks)$l[A]=($l[A]||[]).concat(S.hooks[A])});let vm=(S,A,N)=>N,En=Tn({key:null,setSeries:!1,filters:{pub:Sy,sub:Sy},scales:[E,x[1]?x[1].scale:null],match:[by,by,vm],values:[null,null]},ut.sync);En.match.length==2&&En.match.push(vm),ut.sync=En;let Sm=En.key,Qu=xv(Sm);function Pa(S,A,N,U,W,J,lt){En.filters.pub(S,A,N,U,W,J,lt)&&Qu.pub(S,A,N,U,W,J,lt)}Qu.sub(i);function ES(S,A,N,U,W,J,lt){En.filters.sub(S,A,N,U,W,J,lt)&&vo[S](null,A,N,U,W,J,lt)}i.pub=ES;function AS(){Qu.unsub(i),Np.delete(i),On.clear(),Rp(Iu,ma,ym),c.remove(),Ct?.remove(),Bn("destroy")}i.destroy=AS;function td(){Bn("init",n,t),Ea(t||n.data,!1),G[E]?$u(E,G[E]):Aa(),st=Je.show&&(Je.width>0||Je.height>0),nt=pt=!0,B(n.width,n.height)}return x.forEach(co),b.forEach(Ts),e?e instanceof HTMLElement?(e.appendChild(c),td()):e(i,td):td(),i}Yn.assign=Tn;Yn.fmtNum=Gp;Yn.rangeNum=Lu;Yn.rangeLog=Ou;Yn.rangeAsinh=kp;Yn.orient=lo;Yn.pxRatio=Re;Yn.join=NP;Yn.fmtDate=Hp,Yn.tzDate=XP;Yn.sync=xv;{Yn.addGap=TI,Yn.clipGaps=Bu;let n=Yn.paths={points:Mv};n.linear=Av,n.stepped=PI,n.bars=II,n.spline=DI}var Iv=(n,t,...e)=>X("figure",{class:n},n==="table"?Pv(n,t):null,...e,n==="table"?null:Pv(n,t)),Pv=(n,t)=>X("figcaption",{class:`${n}-caption`},t??"");var jp={width:26,height:4};function Jp({color:n="var(--ink)",mark:t="box",dash:e}){if(t!=="line")return X("span",{class:`swatch ${t}`,style:`--swatch: ${n}`});let i=jp.height/2;return cn("svg",{class:"swatch-line",...jp,"aria-hidden":"true"},cn("line",{x1:0,x2:jp.width,y1:i,y2:i,style:`stroke: ${n}`,"stroke-width":3,"stroke-dasharray":e?.join(" ")}))}function WI({name:n,...t},e){let i=X("button",{type:"button","aria-pressed":"true",title:`Hide or show ${n}`},Jp(t),n);return i.addEventListener("click",()=>{let s=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(s)),e(n,s)}),i}var Lv=(n,t)=>X("div",{class:"legend",role:"group","aria-label":"Legend"},...n.map(e=>WI(e,t)));var Kp=(n,t)=>ra(n)&&(!t||n>0);function XI(n,{log_x:t,log_y:e}){return n.x.map((s,r)=>({x:s,y:Kp(n.y[r],e)?n.y[r]:null,low:Dv(n.band_low,r,e),high:Dv(n.band_high,r,e),label:n.labels?.[r],hint:n.hints?.[r]})).filter(({x:s})=>Kp(s,t)).sort((s,r)=>s.x-r.x)}var Dv=(n,t,e)=>n&&Kp(n[t],e)?n[t]:null;function $I(n){let t=new Map;for(let e of n){let i=new Map;for(let{x:s}of e)i.set(s,(i.get(s)??0)+1);for(let[s,r]of i)t.set(s,Math.max(r,t.get(s)??0))}return[...t].sort(([e],[i])=>e-i).flatMap(([e,i])=>Array(i).fill(e))}function YI(n,t,e){let i=0;return t.map(s=>i<n.length&&n[i].x===s?n[i++][e]:void 0)}function qI(n,t,e){return(e?["y","low","high"]:["y"]).map(i=>YI(n,t,i))}function Qp(n){let t=n.series.map(o=>XI(o,n)),e=$I(t),i=[e],s=[],r=0;return n.series.forEach((o,a)=>{let l=!!(o.band_low&&o.band_high);i.push(...qI(t[a],e,l)),s.push({series:a,part:"y"},...l?[{series:a,part:"low"},{series:a,part:"high"}]:[]),r+=o.x.length-t[a].filter(({y:c})=>c!==null).length}),{data:i,plan:s,points:t,lost:r}}function Nv(n,t,e,i){let s=null;return n.forEach((r,o)=>{if(t[o])for(let a of r){if(a.y===null)continue;let l=e(a);(!s||l<s.d)&&(s={...a,s:o,d:l})}}),s&&s.d<i?s:null}var ZI=({style:n="lines"})=>n!=="points";function Ov(n,t,e){let i=t.flatMap((s,r)=>e[r]&&ZI(n.series[r])?s.filter(({y:o})=>o!==null).map(({x:o})=>o):[]);return[...new Set(i)].sort((s,r)=>s-r)}function Uv(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return Math.abs(n[i]-t)<Math.abs(n[e]-t)?n[i]:n[e]}function tm(n,t,e){return n.flatMap((i,s)=>t[s]?i.filter(r=>r.x===e&&r.y!==null).map(r=>({...r,s})):[]).sort((i,s)=>s.y-i.y)}var em=["blue","vermillion","green","purple","orange","sky","ink","indigo","brown","wine"];var Fv=[void 0,[8,4],[2,3],[10,3,2,3]],jI=n=>`var(--${em[n%em.length]})`,JI=n=>Fv[Math.floor(n/em.length)%Fv.length];function Es(n){let t=KI(n.filter(({faint:e})=>!e).map(({name:e})=>e));return n.map(({name:e,faint:i})=>i?{color:"var(--muted)",dash:void 0}:{color:jI(t.get(e)),dash:JI(t.get(e))})}function KI(n){let t=new Map;for(let e of n)t.has(e)||t.set(e,t.size);return t}var As=null;function QI(n){let e=As.offsetWidth,i=As.offsetHeight,s=n.clientX+14+e>innerWidth?n.clientX-14-e:n.clientX+14,r=n.clientY+14+i>innerHeight?n.clientY-14-i:n.clientY+14;As.style.left=`${Math.max(0,s)}px`,As.style.top=`${Math.max(0,r)}px`}function Bv(n,t){As??(As=document.body.appendChild(X("div",{class:"tooltip",role:"status"}))),As.replaceChildren(...t.map((e,i)=>X(i===0?"strong":"div",{},e))),As.hidden=!1,QI(n)}var kv=(n,t,e,i=!1)=>X("span",{class:i?"reading near":"reading"},Jp({...n,mark:"line"}),X("span",{},t),X("span",{class:"value"},e));function zv(){As&&(As.hidden=!0)}var t2=28,e2=14,Gv=(n,t)=>{let{name:e}=n.series[t.s];return t.label??t.hint?`${e}: ${t.label??t.hint}`:e};function n2(n,t){let e=n.log_y?0:If(t.flat().map(({y:i})=>i));return i=>{let s=o=>pe(o,void 0,e);return i.low!==null&&i.high!==null?`${s(i.y)} (${s(i.low)} to ${s(i.high)})`:s(i.y)}}var i2=(n,t,e)=>[Gv(n,t),`${n.x_label??"x"}: ${pe(t.x)}`,`${n.y_label??"y"}: ${e(t)}`];function s2(n,t,e,i,s){let r=t.slice(0,e2),o=r.map(l=>kv(i[l.s],Gv(n,l),s(l),e?.s===l.s)),a=t.length-r.length;return[`${n.x_label??"x"}: ${pe(t[0].x)}`,...o,...a?[`and ${a} more`]:[]]}function r2(n,t,e,i,s,r,o,a){let c=Nv(e,i,f=>Math.hypot(n.valToPos(f.x,"x")-o,n.valToPos(f.y,"y")-a),t2),h=Ov(t,e,i);if(!h.length)return c&&{words:i2(t,c,r),at:c};let d=c?c.x:Uv(h,n.posToVal(o,"x")),u=tm(e,i,d);return{words:s2(t,u,c,s,r),at:c??u[0]}}function Vv(n,t,e,i,s){let r=t.over.appendChild(X("span",{class:"ring",hidden:!0})),o=Es(e.series),a=n2(e,i),l=()=>{r.hidden=!0,zv()},c=(d,u,f)=>{let p=r2(t,e,i,s,o,a,u,f);if(!p)return l();r.hidden=!1,r.style.left=`${t.valToPos(p.at.x,"x")}px`,r.style.top=`${t.valToPos(p.at.y,"y")}px`,Bv(d,p.words)};t.over.addEventListener("pointerleave",l),t.over.addEventListener("pointermove",d=>{let u=t.over.getBoundingClientRect();c(d,d.clientX-u.left,d.clientY-u.top)});let h=-1;n.addEventListener("blur",l),n.addEventListener("keydown",d=>{let u={ArrowLeft:-1,ArrowRight:1}[d.key];if(d.key==="Escape"&&l(),!u)return;d.preventDefault();let f=i.flatMap((b,v)=>s[v]?b.filter(C=>C.y!==null):[]),p=[...new Set(f.map(({x:b})=>b))].sort((b,v)=>b-v);if(!p.length)return;h=Math.min(p.length-1,Math.max(0,h+u));let[_]=tm(i,s,p[h]),[m,g]=[t.valToPos(_.x,"x"),t.valToPos(_.y,"y")],x=t.over.getBoundingClientRect();c({clientX:x.left+m,clientY:x.top+g},m,g)})}var Hv=(n,t)=>n.left<t.right&&t.left<n.right&&n.top<t.bottom&&t.top<n.bottom,Wv=([n,t],{width:e,height:i})=>({left:n,top:t,right:n+e,bottom:t+i}),Xv=(n,t)=>n.left>=t.left&&n.right<=t.left+t.width&&n.top>=t.top&&n.bottom<=t.top+t.height;function $v(n){let t=[];return n.forEach((e,i)=>{let s=n[i-1];if(!e)return;let r=s?Math.ceil(Math.hypot(e[0]-s[0],e[1]-s[1])/5):0;for(let o=1;o<r;++o)t.push(s.map((a,l)=>a+o/r*(e[l]-a)));t.push(e)}),t}function Yv([n,t],e,i,s){let r=.7*e.height;return[[n+r,t-e.height/2],[n-r-e.width,t-e.height/2],[n-e.width/2,t-r-e.height],[n-e.width/2,t+r]].map(o=>Wv(o,e)).find(o=>Xv(o,i)&&!s.some(a=>Hv(o,a)))}function o2(n,t,e,i,s){let r=n==="y"?i.width-e.width:i.height-e.height,o=n==="y"?i.left:i.top,a=[0,1,.5,.25,.75].map(c=>o+s+c*(r-2*s)),l=n==="y"?[t-s-e.height,t+s]:[t+s,t-s-e.width];return a.flatMap(c=>l.map(h=>n==="y"?[c,h]:[h,c]))}function qv({axis:n,at:t},e,i,s,r){let o=.4*e.height,a=l=>(Xv(l,i)?0:1e6)+1e3*r.filter(c=>Hv(l,c)).length+s.filter(([c,h])=>c>l.left-o&&c<l.right+o&&h>l.top-o&&h<l.bottom+o).length;return o2(n,t,e,i,o).map(l=>Wv(l,e)).reduce((l,c)=>a(c)<a(l)?c:l)}var a2=12,Zv=n=>`${a2*n}px system-ui, sans-serif`,l2=(n,t)=>t.label??(n.x.length===1&&n.style==="points"?n.name:null),jv=(n,t)=>t.map(({x:e,y:i})=>i===null?null:[n.valToPos(e,"x",!0),n.valToPos(i,"y",!0)]);function c2(n,t,e,i,s){let{left:r,top:o,width:a,height:l}=n.bbox,c={lines:[],texts:[]};for(let{axis:h="y",value:d,label:u}of t){let f=Math.round(n.valToPos(d,h,!0));if(c.lines.push(h==="y"?[r,f,r+a,f]:[f,o,f,o+l]),!u)continue;let p=qv({axis:h,at:f},i(u),n.bbox,e,s);s.push(p),c.texts.push({text:u,place:p,color:"--muted"})}return c}function h2(n,t,e,i,s,r){let o=Es(t.series),a=[];return e.forEach((l,c)=>{if(!i[c])return;let h=jv(n,l);l.forEach((d,u)=>{let f=l2(t.series[c],d);f&&h[u]&&a.push({text:f,at:h[u],color:o[c].color})})}),a.flatMap(({text:l,at:c,color:h})=>{let d=Yv(c,s(l),n.bbox,r);return d?(r.push(d),[{text:l,place:d,color:h}]):[]})}function Vu(n,t,e,i){let s=devicePixelRatio;n.ctx.save(),n.ctx.font=Zv(s);let r=u=>({width:n.ctx.measureText(u).width,height:13*s}),o=e.map((u,f)=>i[f]?jv(n,u):[]),a=4*s,l=o.flat().filter(Boolean).map(([u,f])=>({left:u-a,right:u+a,top:f-a,bottom:f+a})),c=o.flatMap((u,f)=>t.series[f].style==="points"?u.filter(Boolean):$v(u)),h=[],d=c2(n,t.reference_lines??[],c,r,h);return l.push(...h),d.texts.push(...h2(n,t,e,i,r,l)),n.ctx.restore(),d}function u2(n,{text:t,place:e,color:i},s){let r=(e.top+e.bottom)/2;n.lineWidth=4*s,n.strokeStyle=rn("--page"),n.strokeText(t,e.left,r),n.fillStyle=rn(i),n.fillText(t,e.left,r)}function Jv(n,{lines:t,texts:e}){let{ctx:i}=n,s=devicePixelRatio;i.save(),i.setLineDash([5*s,4*s]),i.lineWidth=s,i.strokeStyle=rn("--muted");for(let[r,o,a,l]of t)i.beginPath(),i.moveTo(r,o),i.lineTo(a,l),i.stroke();i.setLineDash([]),i.font=Zv(s),i.textAlign="left",i.textBaseline="middle";for(let r of e)u2(i,r,s);i.restore()}var d2=320,Kv="12px system-ui, sans-serif",f2=1e-4;function p2(n,{series:t,part:e},i,s){let r=n.series[t].style??"lines";return e!=="y"?{stroke:"transparent",width:0,points:{show:!1}}:{label:n.series[t].name,stroke:()=>i(t)+(n.series[t].faint?"a0":""),width:r==="points"?0:n.series[t].faint?1:2,dash:s,paths:r==="points"?()=>null:void 0,points:{show:r==="points"||r==="both",size:8,fill:()=>i(t),stroke:()=>i(t)}}}var m2=(n,t)=>n.flatMap(({series:e,part:i},s)=>i==="high"?[{series:[s+1,s],fill:()=>`${t(e)}33`}]:[]),Qv=(n,t)=>({label:n,labelSize:26,labelFont:Kv,font:Kv,stroke:()=>rn("--ink"),grid:{stroke:()=>rn("--faint"),width:1},ticks:{stroke:()=>rn("--faint")},...t?{splits:g2,filter:(e,i)=>i}:{},values:(e,i)=>t?i.map(s=>pe(s)):Lf(i)});function g2(n,t,e,i){let s=Math.floor(Math.log10(e)),r=Math.ceil(Math.log10(i)),o=Math.ceil((r-s)/9),a=r-s<=2?[1,2,5]:[1],l=[];for(let c=Math.ceil(s/o)*o;c<=r;c+=o)l.push(...a.map(h=>+`${h}e${c}`));return l.filter(c=>c>=e&&c<=i)}function tS(n,t){return(e,i,s)=>{let r=[i,s,...t].filter(a=>ra(a)&&(!n||a>0)),o=b_(n?r.map(Math.log10):r,.06,f2);return n?o.map(a=>10**a):o}}function eS(n,t,e,i){let s=Es(n.series),r=a=>rn(s[a].color),o=a=>(n.reference_lines??[]).filter(l=>(l.axis??"y")===a).map(l=>l.value);return{width:i,height:n.height??d2,legend:{show:!1},padding:[12,16,0,0],cursor:{drag:{x:!0,y:!0,uni:20},points:{show:!1}},scales:{x:{time:!1,distr:n.log_x?3:1,range:tS(n.log_x,o("x"))},y:{distr:n.log_y?3:1,range:tS(n.log_y,o("y"))}},axes:[{...Qv(n.x_label,n.log_x),size:34},{...Qv(n.y_label,n.log_y),size:64}],series:[{},...t.plan.map(a=>p2(n,a,r,s[a.series].dash))],bands:m2(t.plan,r),hooks:{draw:[a=>Jv(a,Vu(a,n,t.points,e))]}}}function nS(n){let t="M";return n.map(([e,i])=>{if(!Number.isFinite(e)||!Number.isFinite(i))return t="M","";let s=`${t}${e.toFixed(1)} ${i.toFixed(1)}`;return t="L",s}).join("")}var _2=0,nm=(n,t,e,i,s,r={})=>cn("line",{x1:n,y1:t,x2:e,y2:i,stroke:s,...r});function x2(n,t,{x_label:e,y_label:i}){let s=rn("--ink"),r=rn("--faint"),[o,a]=n.axes.map(({_splits:c,_values:h})=>(c??[]).map((d,u)=>({value:d,text:h[u]}))),l=(c,h)=>cn("text",{style:`fill: ${s}`,...c},h??"");return[...o.flatMap(({value:c,text:h})=>[nm(t.x(c),t.top,t.x(c),t.bottom,r),l({x:t.x(c),y:t.bottom+18,"text-anchor":"middle"},h)]),...a.flatMap(({value:c,text:h})=>[nm(t.left,t.y(c),t.right,t.y(c),r),l({x:t.left-8,y:t.y(c)+4,"text-anchor":"end"},h)]),l({x:(t.left+t.right)/2,y:t.bottom+46,"text-anchor":"middle"},e),l({"text-anchor":"middle",transform:`translate(14 ${(t.top+t.bottom)/2}) rotate(-90)`},i)]}function y2({style:n="lines",faint:t},e,{color:i,dash:s},r){let o=rn(i),a=h=>nS(e.map(d=>[r.x(d.x),d[h]===null?NaN:r.y(d[h])])),l=e.filter(({low:h,high:d})=>h!==null&&d!==null),c=h=>l.map(d=>`${r.x(d.x).toFixed(1)} ${r.y(d[h]).toFixed(1)}`);return[l.length>1?cn("path",{fill:o,"fill-opacity":.2,d:`M${[...c("low"),...c("high").reverse()].join("L")}Z`}):null,n==="points"?null:cn("path",{fill:"none",stroke:o,"stroke-width":t?1:2,"stroke-opacity":t?.63:1,"stroke-dasharray":s?.join(" "),d:a("y")}),...n==="lines"?[]:e.filter(({y:h})=>h!==null).map(h=>cn("circle",{fill:o,cx:r.x(h.x),cy:r.y(h.y),r:4}))]}function iS(n,t,e,i){let s=devicePixelRatio,{left:r,top:o,width:a,height:l}=n.bbox,c={left:r/s,top:o/s,right:(r+a)/s,bottom:(o+l)/s,x:p=>n.valToPos(p,"x",!0)/s,y:p=>n.valToPos(p,"y",!0)/s},h=Es(t.series),d=Vu(n,t,e,i),u=rn("--muted"),f=`chart-clip-${++_2}`;return cn("svg",{class:"plot",width:n.width,height:n.height,viewBox:`0 0 ${n.width} ${n.height}`},cn("clipPath",{id:f},cn("rect",{x:c.left,y:c.top,width:a/s,height:l/s})),...x2(n,c,t),cn("g",{"clip-path":`url(#${f})`},...t.series.flatMap((p,_)=>i[_]?y2(p,e[_],h[_],c):[])),...d.lines.map(p=>nm(...p.map(_=>_/s),u,{"stroke-dasharray":"5 4"})),...d.texts.map(({text:p,place:_,color:m})=>cn("text",{style:`fill: ${rn(m)}`,x:_.left/s,y:(_.top+_.bottom)/2/s+4},p)))}function v2(n,t){let e=()=>{removeEventListener("beforeprint",e),i.disconnect(),n()},i=t(e);addEventListener("beforeprint",e)}var sS=(n,t)=>v2(t,e=>{let i=new ResizeObserver(()=>n.clientWidth&&e());return i.observe(n),i});function Hu(n){let t={...n,type:"lines"},e=Qp(t),i=t.series.map(()=>!0),s=X("div",{class:"chart",role:"img",tabindex:0,"aria-label":`${t.caption}: ${t.y_label} over ${t.x_label}; arrow keys tell values`}),r=null,o=(d,u)=>t.series.forEach((f,p)=>{f.name===d&&(i[p]=u,r?.setSeries(1+e.plan.findIndex(_=>_.series===p),{show:u}))});sS(s,()=>{r=new Yn(eS(t,e,i,s.clientWidth),e.data,s),Vv(s,r,t,e.points,i),new ResizeObserver(()=>{let d=s.clientWidth;d&&d!==r.width&&r.setSize({width:d,height:r.height})}).observe(s),s.toSvg=()=>iS(r,t,e.points,i),s.redraw=()=>r.redraw(!1,!0)});let a=Es(t.series),l=t.series.map(({name:d},u)=>({name:d,...a[u],mark:"line"})),c=Iv("figure",t.caption,Lv(l,o),s),h=d=>{Object.assign(t,d);let u=Qp(t);e.points.splice(0,e.points.length,...u.points),e.data=u.data,r&&r.setData(u.data)};return{figure:U0(t,c),update:h}}var S2=Math.PI/900;function b2(n,t){let{scale:e,unit:i}=Ys(t),s=n.x.map(c=>c/e),r=c=>Object.entries(c??{}).map(([h,d])=>({name:h,x:s,y:d.map(u=>u===null?null:u*1e3)})),o=c=>[{axis:"x",value:c/e}],l={x_label:`${t.name} [${i}]`,height:210};return{cursor:o,arms:{...l,caption:`Moment arms over ${t.name}`,y_label:"moment arm [mm]",series:r(n.arms)},lengths:{...l,caption:`Lengths over ${t.name}`,y_label:"longer than at 0\xB0 [mm]",series:r(n.lengths)}}}function w2(n,t){let e=b2(n,t),i=["arms","lengths"].filter(s=>e[s].series.length).map(s=>{let r={...e[s],reference_lines:e.cursor(n.x[0])};return{block:r,chart:Hu(r)}});return{joint:t,element:X("div",{class:"charts"},...i.map(({chart:s})=>s.figure)),cursor:s=>i.forEach(({block:r,chart:o})=>o.update({...r,reference_lines:e.cursor(s)}))}}function rS(n){let t=X("div",{}),e=Vn("Over",()=>{}),i=[],s=null,r=null;async function o(){let l=i.find(({name:h})=>h===e.value());if(!l)return;let c=await n.ask("tendons.sweep",{joint:l.name,what:["arms","lengths"]});if(c){s=w2(c,l),t.replaceChildren(s.element);for(let h of c.warnings??[])t.prepend(X("p",{class:"warning"},h));a.follow(r)}}let a={element:qe("Over a joint",e,X("div",{class:"buttons"},Be("Plot",o,{id:"plot-sweep"})),t),offer:l=>{i=l,e.set(i.map(({name:c})=>c))},clear:()=>{s=null,t.replaceChildren()},follow:l=>{if(r=l,!s||!l)return;let c=l(s.joint.name);!Number.isFinite(c)||Math.abs(c-(s.drawn??1/0))<S2||(s.drawn=c,s.cursor(c))}};return a}var M2=100,E2=200,A2=n=>n.max_force??n.strength??n.upper??M2;function T2({tip_force:n,torques:t,status:e}){let i=[];n&&(i.push(["Tip force",`${pe(Math.hypot(...n),2)}\u202FN`]),i.push(["along x, y, z",`${n.map(s=>pe(s,2)).join(", ")} N`]));for(let[s,r]of Object.entries(t??{}))i.push([`Torque ${s}`,`${pe(r*1e3)} N mm`]);return e&&i.push(["Status",String(e)]),i}function C2(n,t,e){let i=(s,r,o,a,l)=>({name:r,row:xs({name:r,lower:o,upper:a,quantity:l},c=>e(s,r,c))});return{posture:n.map(s=>i("posture",s.name,s.lower,s.upper,Ys(s))),tensions:t.map(s=>i("tensions",s.name,0,A2(s),Gi.force)),excitations:t.map(s=>i("excitations",s.name,0,1,Gi.share))}}function oS(n){let{store:t}=n,e=X("div",{class:"hint"}),i=X("div",{}),s=X("div",{}),r=X("div",{}),o=Zs(["muscle","tension [N]","longer than at 0\xB0 [mm]"],[],"Tensions"),a=Zs(["band","tension [N]",""],[],"Bands"),l=X("div",{}),c=rS(n),h=null,d={posture:[],tensions:[],excitations:[]},u=Js(async({method:y,params:w})=>{let I=await n.ask(y,w);I&&g(I)},eu),f=(y,w,I)=>u({method:"tendons.set",params:{[y]:{[w]:I}}});function p(){let y=t.scene.joints.filter(I=>!I.led_by),w=h.muscles??[];d=C2(y,w,f),i.replaceChildren(...d.posture.map(({row:I})=>I)),s.replaceChildren(...d.tensions.map(({row:I})=>I)),r.replaceChildren(...d.excitations.map(({row:I})=>I)),c.offer(y),c.clear()}function _(){let y=h.muscles??[];d.tensions.forEach(({row:I},P)=>I.set(y[P]?.tension)),d.excitations.forEach(({row:I},P)=>I.set(y[P]?.excitation??I.value())),js(o.querySelector("tbody"),y.map(I=>[I.name,pe(I.tension,2),pe(I.length*1e3,2)]));let w=h.bands??[];a.hidden=w.length===0,js(a.querySelector("tbody"),w.map(I=>[I.name,pe(I.tension,2),I.slack?"slack":""])),l.replaceChildren(wr(T2(h)),...Kh(h.warnings))}let m=tu(async()=>{if(v.hidden||t.scene?.mode!=="tendons"||!n.link.connected())return;let y=await n.ask("tendons.state");y&&g(y)},E2);function g(y){let w=[y.subject,y.digit,y.muscles?.map(P=>P.name),t.scene.joints],I=JSON.stringify(w);h=y,v.dataset.key!==I&&p(),v.dataset.key=I,_()}let x=X("div",{class:"buttons"},Be("Open a digit\u2026",()=>n.openDialog("subjects")),aa(n)),b=X("div",{},qe("Posture",i),qe("Tensions",s),qe("Excitations",r),qe("At rest",l,o,a),c.element),v=X("div",{class:"page tendons"},e,x,b);function C(){if(t.scene?.mode!=="tendons"||!t.frame)return;let y=w=>t.frame.joints[t.scene.joints.findIndex(I=>I.name===w)];for(let{name:w,row:I}of d.posture)I.set(y(w));c.follow(y)}let E=()=>{let y=t.scene?.mode==="tendons";b.hidden=!y,e.hidden=y,e.textContent="No digit with tendons is shown.",y&&m()};return t.on(["scene","tab"],E),t.on(["frame"],()=>{C(),v.hidden||m()}),E(),v}var R2=200,aS=1500,P2=n=>Object.fromEntries(Object.entries(n??{}).filter(([,t])=>Number.isFinite(t)));function I2(){let n={t:[],values:new Map};return n.add=(t,e)=>{for(;n.t.length&&n.t.at(-1)>=t;){n.t.pop();for(let i of n.values.values())i.pop()}for(let i of Object.keys(e))n.values.has(i)||n.values.set(i,n.t.map(()=>null));n.t.push(t);for(let[i,s]of n.values)s.push(e[i]??null);if(n.t.length>aS){let i=(s,r)=>r%2===0||r>aS/2;n.t=n.t.filter(i);for(let[s,r]of n.values)n.values.set(s,r.filter(i))}},n.clear=()=>{n.t=[],n.values=new Map},n.series=()=>[...n.values].map(([t,e])=>({name:t,x:n.t,y:e})),n}function L2(n){return{caption:"Energies",x_label:"time [s]",y_label:"energy [J]",height:200,series:n.series()}}function lS(n){let t=I2(),e=X("div",{class:"charts"}),i=X("p",{class:"warning",role:"alert",hidden:!0}),s=null,r=0,o=0;function a(h){o+=h.unsolved??0,i.hidden=o===0,o&&(i.textContent=`${o} steps were not solved; the last ones leave ${pe(h.worst_residual??NaN)} of what contacts need.`)}async function l(){let h=performance.now();if(h-r<R2)return;r=h;let d=await n.call("motion.state",{want:["energy"]}).catch(()=>null),u=P2(d?.energy);if(d&&a(d),!d||!Object.keys(u).length)return;t.add(d.t,u);let f=[...t.values.keys()].join(),p=L2(t);s?.names===f?s.update(p):(s={...Hu(p),names:f},e.replaceChildren(s.figure))}return{element:e,warning:i,follow:l,clear:()=>{t.clear(),o=0,i.hidden=!0}}}var cS={effort:{param:"efforts",reach:10},target:{param:"targets",reach:Math.PI},tension:{param:"tensions",reach:100},excitation:{param:"excitations",reach:1}};function D2({unit:n}){return n==="rad"?Gi.angle:n==="m"?Gi.length:{unit:n==="1"?"":n,scale:1,digits:3,step:.01,big:.1}}var hS=({kind:n,name:t})=>`${n} ${t}`;function uS(n){let t=X("div",{}),e=Vn("Input",()=>o()),i=qe("Inputs",e,t),s=[],r=Js(l=>n.ask("motion.set",l));function o(){let l=s.find(_=>hS(_)===e.value());if(!l)return t.replaceChildren();let{param:c,reach:h}=cS[l.kind],d=D2(l),u=l.lower??(c==="efforts"||c==="targets"?-h:0),f=l.upper??h,p=xs({name:l.name,lower:u,upper:f,quantity:d},_=>{l.set=_,r({[c]:{[l.name]:_}})});p.set(l.set??0),t.replaceChildren(p)}async function a(){s=((await n.ask("motion.inputs"))?.inputs??[]).filter(({kind:c})=>c in cS),i.hidden=s.length===0,e.set(s.map(c=>({value:hS(c),text:`${c.name} (${c.kind})`}))),o()}return{element:i,refill:a}}var N2=["0.05","0.1","0.25","0.5","1","2"],O2=12,dS=N2.map(n=>({value:n,text:`${n} \xD7`}));function U2(n,{contacts:t}){let e=i=>n.bodies[i]?.name??"world";return t.map(i=>({...i,size:Math.hypot(...i.force)})).sort((i,s)=>s.size-i.size).slice(0,O2).map(i=>[`${e(i.a)} on ${e(i.b)}`,pe(i.size,2),pe(i.friction,2)])}function fS(n){let{store:t}=n,e=lS(n),i=uS(n),s=Zs(["contact","force [N]","friction"],[],"Contacts"),r=X("output",{class:"clock"}),o=De("Play",()=>u(),{id:"play",class:"main"}),a=X("input",{type:"range",min:0,max:1,value:0,step:"any","aria-label":"Time [s]",class:"scrub"}),l=Vn("Speed",()=>h()?.playing&&n.ask("motion.play",{speed:Number(l.value())}));l.set(dS,"1");let c=0,h=()=>t.state?.motion??null,d=Js(w=>n.ask("motion.seek",{t:w}));a.addEventListener("input",()=>d(Number(a.value)));async function u(){h()&&(h().playing?await n.ask("motion.pause"):await n.ask("motion.play",{speed:Number(l.value())}))}let f=w=>n.ask("motion.step",{steps:w});async function p(){e.clear(),await n.ask("motion.open")}async function _(){e.clear(),c=0,await n.ask("motion.reset")}function m(){if(y.hidden||!t.frame||!(t.scene?.mode==="motion"))return;let{time:I}=t.frame;c=Math.max(c,I,h()?.duration??0),a.max=c||1,a.value=I,a.setAttribute("aria-valuetext",`${I.toFixed(3)} s`),r.textContent=`${I.toFixed(3)}\u202Fs`,js(s.querySelector("tbody"),U2(t.scene,t.frame)),h()?.recorded||e.follow()}let g=()=>{let w=h(),I=t.scene?.mode==="motion";E.hidden=!I,x.textContent=I?"":w?"A motion is open, but not shown.":"No motion is open: begin with the world as it stands, or open a scene.",b.hidden=I||!w,o.textContent=w?.playing?"Pause":"Play",o.setAttribute("aria-pressed",String(!!w?.playing)),w?.speed&&l.set(dS,String(w.speed)),v.textContent=I?"Begin anew from the world":"Begin from this world";for(let P of C)P.hidden=!!w?.recorded},x=X("p",{class:"hint"}),b=Be("Show the motion",()=>n.ask("session.mode",{mode:"motion"})),v=Be("Begin from this world",p,{id:"begin-motion"}),C=[Be("Step",()=>f(1),{id:"step",title:"One step of time"}),Be("10 steps",()=>f(10)),Be("Reset",_,{title:"Back to the beginning"})],E=X("div",{},X("div",{class:"buttons"},o,...C),X("div",{class:"scrubber"},a,r),l,e.warning,i.element,qe("Contacts",s),qe("Energy",e.element)),y=X("div",{class:"page time"},x,X("div",{class:"buttons"},b,v,Be("Open a scene\u2026",()=>n.openDialog("scenes")),aa(n)),Jh("Run",w=>n.ask("motion.record",{file:w})),E);return t.on(["scene","state","tab"],g),t.on(["frame","tab"],m),t.on(["scene"],()=>{if(t.scene?.mode==="motion"){i.element.hidden=!!h()?.recorded,h()?.recorded||i.refill();return}e.clear(),c=0}),n.togglePlay=u,n.stepTime=f,g(),y}var F2=[["hand","Hands"],["object","Objects"],["obstacle","Obstacles"]];function B2(n,{name:t,movable:e}){let{store:i,picture:s}=n,r=s.bodies.hidden.has(t),o=De(t,()=>n.select({owner:t}),{class:"pick","aria-pressed":String(i.selected?.owner===t),title:e?`Select ${t}`:`Select ${t}, which stands fast`}),a=De(r?"\u25CB":"\u25CF",()=>n.hide(t,!r),{class:"eye","aria-pressed":String(!r),"aria-label":`Show ${t}`,title:r?"Show":"Hide"}),l=De("\xD7",()=>n.ask("world.remove",{name:t}),{class:"away","aria-label":`Remove ${t}`,title:"Remove from the world"});return X("li",{},a,o,i.scene.mode==="world"?l:null)}function pS(n){let{store:t}=n,e=X("div",{class:"tree-body"}),i=X("nav",{class:"tree","aria-label":"World"},X("h2",{},"World"),e),s=()=>{let r=t.scene?Mr(t.scene):[],o=document.activeElement?.closest(".tree")?document.activeElement:null,a=o&&[o.className,o.closest("li")?.textContent],l=F2.flatMap(([h,d])=>{let u=r.filter(f=>f.kind===h);return u.length?[X("h3",{},d),X("ul",{},...u.map(f=>B2(n,f)))]:[]}),c=X("p",{class:"hint"},"Nothing is here yet. Open a world, add a hand or an object, or drop files onto the picture.");e.replaceChildren(...l.length?l:[c]),a&&[...e.querySelectorAll("button")].find(h=>h.className===a[0]&&h.closest("li").textContent===a[1])?.focus()};return t.on(["scene","selected","hidden"],s),s(),i}var k2={world:"pose",motion:"time",tendons:"tendons",fit:"fit"},Wu=matchMedia("(max-width: 700px)");function z2(n,t){let e=[{id:"pose",title:"Pose",element:u_(n)},{id:"grasp",title:"Grasp",element:ey(n)},{id:"tendons",title:"Tendons",element:oS(n)},{id:"fit",title:"Fit",element:vx(n)},{id:"time",title:"Time",element:fS(n)},{id:"world",title:"World",element:X("div",{class:"page world"})}];n.tabs=X0(e,"Panels",l=>n.store.set({tab:l}));let i=De("\u25BE",()=>{let l=s.classList.toggle("folded");i.setAttribute("aria-expanded",String(!l)),i.textContent=l?"\u25B4":"\u25BE",im(n)},{class:"fold-panel","aria-expanded":"true","aria-label":"Fold the panel"}),s=X("aside",{class:"side","aria-label":"Controls"},X("div",{class:"side-head"},n.tabs.list,i),X("div",{class:"pages"},...e.map(({element:l})=>l))),r=X("div",{class:"tree-home"}),o=()=>{(Wu.matches?e.at(-1).element:r).append(t),!Wu.matches&&n.tabs.chosen()==="world"&&n.tabs.choose("pose")};Wu.addEventListener("change",o),o(),n.tabs.choose("pose");let a="world";return n.store.on(["scene"],({scene:l})=>{l.mode!==a&&n.tabs.choose(k2[l.mode]??"pose"),a=l.mode}),{side:s,home:r}}function im(n){let t=a=>document.querySelector(a)?.getBoundingClientRect(),[e,i,s]=[t(".bar"),t(".side"),t(".tree-home")],r=Wu.matches,o={top:e?.bottom??0,left:r||!s?.width?0:s.right,right:r?0:innerWidth-(i?.left??innerWidth),bottom:r?innerHeight-(i?.top??innerHeight):0};for(let[a,l]of Object.entries(o))document.documentElement.style.setProperty(`--inset-${a}`,`${l}px`);n.picture.stage.setInsets(o)}function G2(){let n=X("main",{class:"view","aria-label":"Picture"});document.body.append(n);let t=hx(document.body,n);t.help=$0(),t.openDialog=iy(t);let{side:e,home:i}=z2(t,pS(t));document.body.prepend(_x(t),i),n.after(e),t.picture.stage.canvas.setAttribute("role","application"),t.picture.stage.canvas.setAttribute("aria-label","3D picture; press ? for its keys"),t.picture.stage.canvas.addEventListener("dblclick",()=>t.view.fit()),mx(t),gx(t),Cm(),addEventListener("resize",()=>im(t)),im(t),t.connect(),globalThis.thenarLive=t}try{G2()}catch(n){throw document.body.append(X("p",{class:"broken",role:"alert"},`The page cannot be shown: ${n.message}`)),n}})();
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
