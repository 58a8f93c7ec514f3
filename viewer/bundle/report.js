/*! Contains three.js (MIT, three.js authors), uPlot (MIT, Leon Sorokin), lil-gui (MIT, George Michael Brower). */
(()=>{var IS="http://www.w3.org/2000/svg";function Cm(n,t,e){for(let[i,s]of Object.entries(t))s==null||s===!1||(i.startsWith("on")?n.addEventListener(i.slice(2),s):i==="style"?n.style.cssText=s:n.setAttribute(i,s===!0?"":s));return n.append(...e.filter(i=>i!=null)),n}var q=(n,t={},...e)=>Cm(document.createElement(n),t,e),ct=(n,t={},...e)=>Cm(document.createElementNS(IS,n),t,e),$l=n=>n.split(/(?<=\/)/).flatMap((t,e)=>e===0?[t]:[q("wbr"),t]),Yl=n=>String(n??"").split(/\n\s*\n/).filter(t=>t.trim()).map(t=>q("p",{},t.trim()));var pn=(n,t,...e)=>q("figure",{class:n},n==="table"?Rm(n,t):null,...e,n==="table"?null:Rm(n,t)),Rm=(n,t)=>q("figcaption",{class:`${n}-caption`},t??""),Js=n=>n?q("p",{class:"remark"},n):null,Cs=n=>q("div",{class:"error",role:"alert"},n);var ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},dr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ug=0,Ed=1,dg=2;var Ur=1,fg=2,Ho=3,fr=0,ni=1,Fn=2,Or=0,Wo=1,Ad=2,Td=3,Cd=4,pg=5;var Fr=100,mg=101,gg=102,_g=103,xg=104,yg=200,vg=201,Sg=202,Mg=203,Rd=204,Pd=205,bg=206,wg=207,Eg=208,Ag=209,Tg=210,Cg=211,Rg=212,Pg=213,Ig=214,bc=0,wc=1,Ec=2,Io=3,Ac=4,Tc=5,Cc=6,Rc=7,ih=0,Lg=1,Dg=2,fs=0,Id=1,Ld=2,Dd=3,Nd=4,Ud=5,Od=6,Fd=7;var Bd=300,Br=301,Xo=302,sh=303,rh=304,Pc=1e3,hs=1001,Ic=1002,On=1003,Ng=1004;var ll=1005;var ei=1006,oh=1007;var Bs=1008;var li=1009,zd=1010,kd=1011,$o=1012,ah=1013,Ji=1014,Ui=1015,Ki=1016,lh=1017,ch=1018,zr=1020,Vd=35902,Gd=35899,Hd=1021,Wd=1022,ji=1023,Os=1026,zs=1027,hh=1028,uh=1029,pr=1030,dh=1031;var fh=1033,cl=33776,hl=33777,ul=33778,dl=33779,ph=35840,mh=35841,gh=35842,_h=35843,xh=36196,yh=37492,vh=37496,Sh=37488,Mh=37489,fl=37490,bh=37491,wh=37808,Eh=37809,Ah=37810,Th=37811,Ch=37812,Rh=37813,Ph=37814,Ih=37815,Lh=37816,Dh=37817,Nh=37818,Uh=37819,Oh=37820,Fh=37821,Bh=36492,zh=36494,kh=36495,Vh=36283,Gh=36284,pl=36285,Hh=36286;var Da=2300,Lc=2301,Sc=2302,_d=2303,xd=2400,yd=2401,vd=2402;var Ug=3200;var ml=0,Og=1,ks="",xi="srgb",Na="srgb-linear",Ua="linear",Re="srgb";var Mc=7680;var Fg=519,Bg=512,zg=513,kg=514,Xd=515,Vg=516,Gg=517,$d=518,Yd=519,qd=35044;var Zd="300 es",Li=2e3,Lo=2001;function LS(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function DS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Oa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Hg(){let n=Oa("canvas");return n.style.display="block",n}var Pm={},Do=null;function Fa(...n){let t="THREE."+n.shift();Do?Do("log",t,...n):console.log(t,...n)}function Wg(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Jt(...n){n=Wg(n);let t="THREE."+n.shift();if(Do)Do("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function ee(...n){n=Wg(n);let t="THREE."+n.shift();if(Do)Do("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Ia(...n){let t=n.join(" ");t in Pm||(Pm[t]=!0,Jt(...n))}function Xg(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var $g={[bc]:bc,[Ec]:Cc,[Ac]:Ac,[Io]:Tc,[wc]:wc,[Cc]:Ec,[Rc]:Rc,[Tc]:Io},qi=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Xn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Im=1234567,Ro=Math.PI/180,No=180/Math.PI;function mr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Xn[n&255]+Xn[n>>8&255]+Xn[n>>16&255]+Xn[n>>24&255]+"-"+Xn[t&255]+Xn[t>>8&255]+"-"+Xn[t>>16&15|64]+Xn[t>>24&255]+"-"+Xn[e&63|128]+Xn[e>>8&255]+"-"+Xn[e>>16&255]+Xn[e>>24&255]+Xn[i&255]+Xn[i>>8&255]+Xn[i>>16&255]+Xn[i>>24&255]).toLowerCase()}function ce(n,t,e){return Math.max(t,Math.min(e,n))}function Jd(n,t){return(n%t+t)%t}function NS(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function US(n,t,e){return n!==t?(e-n)/(t-n):0}function La(n,t,e){return(1-e)*n+e*t}function OS(n,t,e,i){return La(n,t,1-Math.exp(-e*i))}function FS(n,t=1){return t-Math.abs(Jd(n,t*2)-t)}function BS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function zS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function kS(n,t){return n+Math.floor(Math.random()*(t-n+1))}function VS(n,t){return n+Math.random()*(t-n)}function GS(n){return n*(.5-Math.random())}function HS(n){n!==void 0&&(Im=n);let t=Im+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function WS(n){return n*Ro}function XS(n){return n*No}function $S(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function YS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Kd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function qS(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),m=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*m,l*f,a*c);break;case"YXY":n.set(l*f,a*h,l*m,a*c);break;case"ZYZ":n.set(l*m,l*f,a*h,a*c);break;default:Jt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Wh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jd(n,t){if(t.constructor===Float32Array)return n;let e=Wh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Qd(n,t){if(t.constructor===Float32Array)return n;let e=Wh(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Yo={DEG2RAD:Ro,RAD2DEG:No,generateUUID:mr,clamp:ce,euclideanModulo:Jd,mapLinear:NS,inverseLerp:US,lerp:La,damp:OS,pingpong:FS,smoothstep:BS,smootherstep:zS,randInt:kS,randFloat:VS,randFloatSpread:GS,seededRandom:HS,degToRad:WS,radToDeg:XS,isPowerOfTwo:$S,ceilPowerOfTwo:YS,floorPowerOfTwo:Kd,setQuaternionFromProperEuler:qS,normalize:Qd,denormalize:jd},rf=class rf{constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}};rf.prototype.isVector2=!0;var Zt=rf,Si=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],m=r[o+2],_=r[o+3];if(u!==_||l!==d||c!==f||h!==m){let g=l*d+c*f+h*m+u*_;g<0&&(d=-d,f=-f,m=-m,_=-_,g=-g);let p=1-a;if(g<.9995){let v=Math.acos(g),T=Math.sin(v);p=Math.sin(p*v)/T,a=Math.sin(a*v)/T,l=l*p+d*a,c=c*p+f*a,h=h*p+m*a,u=u*p+_*a}else{l=l*p+d*a,c=c*p+f*a,h=h*p+m*a,u=u*p+_*a;let v=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=v,c*=v,h*=v,u*=v}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],m=r[o+3];return t[e]=a*m+h*u+l*f-c*d,t[e+1]=l*m+h*d+c*u-a*f,t[e+2]=c*m+h*f+a*d-l*u,t[e+3]=h*m-a*u-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),f=l(s/2),m=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"YXZ":this._x=d*h*u+c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"ZXY":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u-d*f*m;break;case"ZYX":this._x=d*h*u-c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u+d*f*m;break;case"YZX":this._x=d*h*u+c*f*m,this._y=c*f*u+d*h*m,this._z=c*h*m-d*f*u,this._w=c*h*u-d*f*m;break;case"XZY":this._x=d*h*u-c*f*m,this._y=c*f*u-d*h*m,this._z=c*h*m+d*f*u,this._w=c*h*u+d*f*m;break;default:Jt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(ce(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},of=class of{constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Lm.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Lm.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return qu.copy(this).projectOnVector(t),this.sub(qu)}reflect(t){return this.sub(qu.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(ce(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}};of.prototype.isVector3=!0;var U=of,qu=new U,Lm=new Si,af=class af{constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],f=i[5],m=i[8],_=s[0],g=s[3],p=s[6],v=s[1],T=s[4],S=s[7],C=s[2],A=s[5],x=s[8];return r[0]=o*_+a*v+l*C,r[3]=o*g+a*T+l*A,r[6]=o*p+a*S+l*x,r[1]=c*_+h*v+u*C,r[4]=c*g+h*T+u*A,r[7]=c*p+h*S+u*x,r[2]=d*_+f*v+m*C,r[5]=d*g+f*T+m*A,r[8]=d*p+f*S+m*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,f=c*r-o*l,m=e*u+i*d+s*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return t[0]=u*_,t[1]=(s*c-h*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(h*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Ia("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Zu.makeScale(t,e)),this}rotate(t){return Ia("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Zu.makeRotation(-t)),this}translate(t,e){return Ia("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Zu.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}};af.prototype.isMatrix3=!0;var se=af,Zu=new se,Dm=new se().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Nm=new se().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ZS(){let n={enabled:!0,workingColorSpace:Na,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Re&&(s.r=Us(s.r),s.g=Us(s.g),s.b=Us(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Re&&(s.r=Po(s.r),s.g=Po(s.g),s.b=Po(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ks?Ua:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Na]:{primaries:t,whitePoint:i,transfer:Ua,toXYZ:Dm,fromXYZ:Nm,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:xi},outputColorSpaceConfig:{drawingBufferColorSpace:xi}},[xi]:{primaries:t,whitePoint:i,transfer:Re,toXYZ:Dm,fromXYZ:Nm,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:xi}}}),n}var Se=ZS();function Us(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Po(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var fo,Dc=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{fo===void 0&&(fo=Oa("canvas")),fo.width=t.width,fo.height=t.height;let s=fo.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=fo}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Oa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Us(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Us(e[i]/255)*255):e[i]=Us(e[i]);return{data:e,width:t.width,height:t.height}}else return Jt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},JS=0,Uo=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:JS++}),this.uuid=mr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ju(s[o].image)):r.push(Ju(s[o]))}else r=Ju(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Ju(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Dc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Jt("Texture: Unable to serialize Texture."),{})}var KS=0,Ku=new U,ai=class n extends qi{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=hs,s=hs,r=ei,o=Bs,a=ji,l=li,c=n.DEFAULT_ANISOTROPY,h=ks){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:KS++}),this.uuid=mr(),this.name="",this.source=new Uo(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new se,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ku).x}get height(){return this.source.getSize(Ku).y}get depth(){return this.source.getSize(Ku).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Jt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Bd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Pc:t.x=t.x-Math.floor(t.x);break;case hs:t.x=t.x<0?0:1;break;case Ic:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Pc:t.y=t.y-Math.floor(t.y);break;case hs:t.y=t.y<0?0:1;break;case Ic:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};ai.DEFAULT_IMAGE=null;ai.DEFAULT_MAPPING=Bd;ai.DEFAULT_ANISOTROPY=1;var lf=class lf{constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],f=l[5],m=l[9],_=l[2],g=l[6],p=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-_)<.01&&Math.abs(m-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+_)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let T=(c+1)/2,S=(f+1)/2,C=(p+1)/2,A=(h+d)/4,x=(u+_)/4,E=(m+g)/4;return T>S&&T>C?T<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(T),s=A/i,r=x/i):S>C?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=A/s,r=E/s):C<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),i=x/r,s=E/r),this.set(i,s,r,e),this}let v=Math.sqrt((g-m)*(g-m)+(u-_)*(u-_)+(d-h)*(d-h));return Math.abs(v)<.001&&(v=1),this.x=(g-m)/v,this.y=(u-_)/v,this.z=(d-h)/v,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=ce(this.x,t.x,e.x),this.y=ce(this.y,t.y,e.y),this.z=ce(this.z,t.z,e.z),this.w=ce(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=ce(this.x,t,e),this.y=ce(this.y,t,e),this.z=ce(this.z,t,e),this.w=ce(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ce(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}};lf.prototype.isVector4=!0;var Pe=lf,Nc=class extends qi{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ei,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new Pe(0,0,t,e),this.scissorTest=!1,this.viewport=new Pe(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ai({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:ei,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Uo(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Mi=class extends Nc{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Ba=class extends ai{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Uc=class extends ai{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=hs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var nh=class nh{constructor(t,e,i,s,r,o,a,l,c,h,u,d,f,m,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,d,f,m,_,g)}set(t,e,i,s,r,o,a,l,c,h,u,d,f,m,_,g){let p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=u,p[14]=d,p[3]=f,p[7]=m,p[11]=_,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new nh().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/po.setFromMatrixColumn(t,0).length(),r=1/po.setFromMatrixColumn(t,1).length(),o=1/po.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,m=a*h,_=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=f+m*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=m+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,f=l*u,m=c*h,_=c*u;e[0]=d+_*a,e[4]=m*a-f,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-m,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,f=l*u,m=c*h,_=c*u;e[0]=d-_*a,e[4]=-o*u,e[8]=m+f*a,e[1]=f+m*a,e[5]=o*h,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,f=o*u,m=a*h,_=a*u;e[0]=l*h,e[4]=m*c-f,e[8]=d*c+_,e[1]=l*u,e[5]=_*c+d,e[9]=f*c-m,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*h,e[4]=_-d*u,e[8]=m*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*u+m,e[10]=d-_*u}else if(t.order==="XZY"){let d=o*l,f=o*c,m=a*l,_=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+_,e[5]=o*h,e[9]=f*u-m,e[2]=m*u-f,e[6]=a*h,e[10]=_*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(jS,t,QS)}lookAt(t,e,i){let s=this.elements;return gi.subVectors(t,e),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),Ks.crossVectors(i,gi),Ks.lengthSq()===0&&(Math.abs(i.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),Ks.crossVectors(i,gi)),Ks.normalize(),ql.crossVectors(gi,Ks),s[0]=Ks.x,s[4]=ql.x,s[8]=gi.x,s[1]=Ks.y,s[5]=ql.y,s[9]=gi.y,s[2]=Ks.z,s[6]=ql.z,s[10]=gi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],f=i[13],m=i[2],_=i[6],g=i[10],p=i[14],v=i[3],T=i[7],S=i[11],C=i[15],A=s[0],x=s[4],E=s[8],O=s[12],I=s[1],L=s[5],z=s[9],V=s[13],D=s[2],H=s[6],$=s[10],G=s[14],lt=s[3],Z=s[7],j=s[11],et=s[15];return r[0]=o*A+a*I+l*D+c*lt,r[4]=o*x+a*L+l*H+c*Z,r[8]=o*E+a*z+l*$+c*j,r[12]=o*O+a*V+l*G+c*et,r[1]=h*A+u*I+d*D+f*lt,r[5]=h*x+u*L+d*H+f*Z,r[9]=h*E+u*z+d*$+f*j,r[13]=h*O+u*V+d*G+f*et,r[2]=m*A+_*I+g*D+p*lt,r[6]=m*x+_*L+g*H+p*Z,r[10]=m*E+_*z+g*$+p*j,r[14]=m*O+_*V+g*G+p*et,r[3]=v*A+T*I+S*D+C*lt,r[7]=v*x+T*L+S*H+C*Z,r[11]=v*E+T*z+S*$+C*j,r[15]=v*O+T*V+S*G+C*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],f=t[14],m=t[3],_=t[7],g=t[11],p=t[15],v=l*f-c*d,T=a*f-c*u,S=a*d-l*u,C=o*f-c*h,A=o*d-l*h,x=o*u-a*h;return e*(_*v-g*T+p*S)-i*(m*v-g*C+p*A)+s*(m*T-_*C+p*x)-r*(m*S-_*A+g*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],f=t[11],m=t[12],_=t[13],g=t[14],p=t[15],v=e*a-i*o,T=e*l-s*o,S=e*c-r*o,C=i*l-s*a,A=i*c-r*a,x=s*c-r*l,E=h*_-u*m,O=h*g-d*m,I=h*p-f*m,L=u*g-d*_,z=u*p-f*_,V=d*p-f*g,D=v*V-T*z+S*L+C*I-A*O+x*E;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/D;return t[0]=(a*V-l*z+c*L)*H,t[1]=(s*z-i*V-r*L)*H,t[2]=(_*x-g*A+p*C)*H,t[3]=(d*A-u*x-f*C)*H,t[4]=(l*I-o*V-c*O)*H,t[5]=(e*V-s*I+r*O)*H,t[6]=(g*S-m*x-p*T)*H,t[7]=(h*x-d*S+f*T)*H,t[8]=(o*z-a*I+c*E)*H,t[9]=(i*I-e*z-r*E)*H,t[10]=(m*A-_*S+p*v)*H,t[11]=(u*S-h*A-f*v)*H,t[12]=(a*O-o*L-l*E)*H,t[13]=(e*L-i*O+s*E)*H,t[14]=(_*T-m*C-g*v)*H,t[15]=(h*C-u*T+d*v)*H,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,f=r*h,m=r*u,_=o*h,g=o*u,p=a*u,v=l*c,T=l*h,S=l*u,C=i.x,A=i.y,x=i.z;return s[0]=(1-(_+p))*C,s[1]=(f+S)*C,s[2]=(m-T)*C,s[3]=0,s[4]=(f-S)*A,s[5]=(1-(d+p))*A,s[6]=(g+v)*A,s[7]=0,s[8]=(m+T)*x,s[9]=(g-v)*x,s[10]=(1-(d+_))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=po.set(s[0],s[1],s[2]).length(),a=po.set(s[4],s[5],s[6]).length(),l=po.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Xi.copy(this);let c=1/o,h=1/a,u=1/l;return Xi.elements[0]*=c,Xi.elements[1]*=c,Xi.elements[2]*=c,Xi.elements[4]*=h,Xi.elements[5]*=h,Xi.elements[6]*=h,Xi.elements[8]*=u,Xi.elements[9]*=u,Xi.elements[10]*=u,e.setFromRotationMatrix(Xi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Li,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),m,_;if(l)m=r/(o-r),_=o*r/(o-r);else if(a===Li)m=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Lo)m=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Li,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),m,_;if(l)m=1/(o-r),_=o/(o-r);else if(a===Li)m=-2/(o-r),_=-(o+r)/(o-r);else if(a===Lo)m=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}};nh.prototype.isMatrix4=!0;var xe=nh,po=new U,Xi=new xe,jS=new U(0,0,0),QS=new U(1,1,1),Ks=new U,ql=new U,gi=new U,Um=new xe,Om=new Si,us=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(ce(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ce(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(ce(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ce(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ce(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-ce(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Jt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Um.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Um,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Om.setFromEuler(this),this.setFromQuaternion(Om,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};us.DEFAULT_ORDER="XYZ";var Oo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},tM=0,Fm=new U,mo=new Si,Rs=new xe,Zl=new U,wa=new U,eM=new U,nM=new Si,Bm=new U(1,0,0),zm=new U(0,1,0),km=new U(0,0,1),Vm={type:"added"},iM={type:"removed"},go={type:"childadded",child:null},ju={type:"childremoved",child:null},zn=class n extends qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:tM++}),this.uuid=mr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new U,e=new us,i=new Si,s=new U(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new xe},normalMatrix:{value:new se}}),this.matrix=new xe,this.matrixWorld=new xe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Oo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return mo.setFromAxisAngle(t,e),this.quaternion.multiply(mo),this}rotateOnWorldAxis(t,e){return mo.setFromAxisAngle(t,e),this.quaternion.premultiply(mo),this}rotateX(t){return this.rotateOnAxis(Bm,t)}rotateY(t){return this.rotateOnAxis(zm,t)}rotateZ(t){return this.rotateOnAxis(km,t)}translateOnAxis(t,e){return Fm.copy(t).applyQuaternion(this.quaternion),this.position.add(Fm.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Bm,t)}translateY(t){return this.translateOnAxis(zm,t)}translateZ(t){return this.translateOnAxis(km,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Rs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Zl.copy(t):Zl.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),wa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Rs.lookAt(wa,Zl,this.up):Rs.lookAt(Zl,wa,this.up),this.quaternion.setFromRotationMatrix(Rs),s&&(Rs.extractRotation(s.matrixWorld),mo.setFromRotationMatrix(Rs),this.quaternion.premultiply(mo.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(ee("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Vm),go.child=t,this.dispatchEvent(go),go.child=null):ee("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(iM),ju.child=t,this.dispatchEvent(ju),ju.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Rs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Rs.multiply(t.parent.matrixWorld)),t.applyMatrix4(Rs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Vm),go.child=t,this.dispatchEvent(go),go.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wa,t,eM),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(wa,nM,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),m=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};zn.DEFAULT_UP=new U(0,1,0);zn.DEFAULT_MATRIX_AUTO_UPDATE=!0;zn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var oi=class extends zn{constructor(){super(),this.isGroup=!0,this.type="Group"}},sM={type:"move"},Fo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new oi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new oi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new oi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let g=e.getJointPose(_,i),p=this._getHandJoint(c,_);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(sM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new oi;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Yg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},Jl={h:0,s:0,l:0};function Qu(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var ne=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=xi){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Se.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Se.workingColorSpace){return this.r=t,this.g=e,this.b=i,Se.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Se.workingColorSpace){if(t=Jd(t,1),e=ce(e,0,1),i=ce(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Qu(o,r,t+1/3),this.g=Qu(o,r,t),this.b=Qu(o,r,t-1/3)}return Se.colorSpaceToWorking(this,s),this}setStyle(t,e=xi){function i(r){r!==void 0&&parseFloat(r)<1&&Jt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Jt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Jt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=xi){let i=Yg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Jt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Us(t.r),this.g=Us(t.g),this.b=Us(t.b),this}copyLinearToSRGB(t){return this.r=Po(t.r),this.g=Po(t.g),this.b=Po(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=xi){return Se.workingToColorSpace($n.copy(this),t),Math.round(ce($n.r*255,0,255))*65536+Math.round(ce($n.g*255,0,255))*256+Math.round(ce($n.b*255,0,255))}getHexString(t=xi){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Se.workingColorSpace){Se.workingToColorSpace($n.copy(this),e);let i=$n.r,s=$n.g,r=$n.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Se.workingColorSpace){return Se.workingToColorSpace($n.copy(this),e),t.r=$n.r,t.g=$n.g,t.b=$n.b,t}getStyle(t=xi){Se.workingToColorSpace($n.copy(this),t);let e=$n.r,i=$n.g,s=$n.b;return t!==xi?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(js),this.setHSL(js.h+t,js.s+e,js.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(js),t.getHSL(Jl);let i=La(js.h,Jl.h,e),s=La(js.s,Jl.s,e),r=La(js.l,Jl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},$n=new ne;ne.NAMES=Yg;var za=class extends zn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new us,this.environmentIntensity=1,this.environmentRotation=new us,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},$i=new U,Ps=new U,td=new U,Is=new U,_o=new U,xo=new U,Gm=new U,ed=new U,nd=new U,id=new U,sd=new Pe,rd=new Pe,od=new Pe,Ns=class n{constructor(t=new U,e=new U,i=new U){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),$i.subVectors(t,e),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){$i.subVectors(s,e),Ps.subVectors(i,e),td.subVectors(t,e);let o=$i.dot($i),a=$i.dot(Ps),l=$i.dot(td),c=Ps.dot(Ps),h=Ps.dot(td),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(c*l-a*h)*d,m=(o*h-a*l)*d;return r.set(1-f-m,m,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Is)===null?!1:Is.x>=0&&Is.y>=0&&Is.x+Is.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Is)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Is.x),l.addScaledVector(o,Is.y),l.addScaledVector(a,Is.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return sd.setScalar(0),rd.setScalar(0),od.setScalar(0),sd.fromBufferAttribute(t,e),rd.fromBufferAttribute(t,i),od.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(sd,r.x),o.addScaledVector(rd,r.y),o.addScaledVector(od,r.z),o}static isFrontFacing(t,e,i,s){return $i.subVectors(i,e),Ps.subVectors(t,e),$i.cross(Ps).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return $i.subVectors(this.c,this.b),Ps.subVectors(this.a,this.b),$i.cross(Ps).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;_o.subVectors(s,i),xo.subVectors(r,i),ed.subVectors(t,i);let l=_o.dot(ed),c=xo.dot(ed);if(l<=0&&c<=0)return e.copy(i);nd.subVectors(t,s);let h=_o.dot(nd),u=xo.dot(nd);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(_o,o);id.subVectors(t,r);let f=_o.dot(id),m=xo.dot(id);if(m>=0&&f<=m)return e.copy(r);let _=f*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),e.copy(i).addScaledVector(xo,a);let g=h*m-f*u;if(g<=0&&u-h>=0&&f-m>=0)return Gm.subVectors(r,s),a=(u-h)/(u-h+(f-m)),e.copy(s).addScaledVector(Gm,a);let p=1/(g+_+d);return o=_*p,a=d*p,e.copy(i).addScaledVector(_o,o).addScaledVector(xo,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Sn=class{constructor(t=new U(1/0,1/0,1/0),e=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Yi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Yi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Yi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Yi):Yi.fromBufferAttribute(r,o),Yi.applyMatrix4(t.matrixWorld),this.expandByPoint(Yi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Kl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Kl.copy(i.boundingBox)),Kl.applyMatrix4(t.matrixWorld),this.union(Kl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Yi),Yi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Ea),jl.subVectors(this.max,Ea),yo.subVectors(t.a,Ea),vo.subVectors(t.b,Ea),So.subVectors(t.c,Ea),Qs.subVectors(vo,yo),tr.subVectors(So,vo),Tr.subVectors(yo,So);let e=[0,-Qs.z,Qs.y,0,-tr.z,tr.y,0,-Tr.z,Tr.y,Qs.z,0,-Qs.x,tr.z,0,-tr.x,Tr.z,0,-Tr.x,-Qs.y,Qs.x,0,-tr.y,tr.x,0,-Tr.y,Tr.x,0];return!ad(e,yo,vo,So,jl)||(e=[1,0,0,0,1,0,0,0,1],!ad(e,yo,vo,So,jl))?!1:(Ql.crossVectors(Qs,tr),e=[Ql.x,Ql.y,Ql.z],ad(e,yo,vo,So,jl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Yi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Yi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ls[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ls[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ls[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ls[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ls[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ls[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ls[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ls[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ls),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ls=[new U,new U,new U,new U,new U,new U,new U,new U],Yi=new U,Kl=new Sn,yo=new U,vo=new U,So=new U,Qs=new U,tr=new U,Tr=new U,Ea=new U,jl=new U,Ql=new U,Cr=new U;function ad(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Cr.fromArray(n,r);let a=s.x*Math.abs(Cr.x)+s.y*Math.abs(Cr.y)+s.z*Math.abs(Cr.z),l=t.dot(Cr),c=e.dot(Cr),h=i.dot(Cr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var mn=new U,tc=new Zt,rM=0,Un=class extends qi{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:rM++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=qd,this.updateRanges=[],this.gpuType=Ui,this.version=0,this._normalizationScale=t!==void 0?Wh(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)tc.fromBufferAttribute(this,e),tc.applyMatrix3(t),this.setXY(e,tc.x,tc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jd(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Qd(t,this.array)}};var ka=class extends Un{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Va=class extends Un{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var ye=class extends Un{constructor(t,e,i){super(new Float32Array(t),e,i)}},oM=new Sn,Aa=new U,ld=new U,bi=class{constructor(t=new U,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):oM.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Aa.subVectors(t,this.center);let e=Aa.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Aa,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(ld.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Aa.copy(t.center).add(ld)),this.expandByPoint(Aa.copy(t.center).sub(ld))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},aM=0,Ii=new xe,cd=new zn,Mo=new U,_i=new Sn,Ta=new Sn,Nn=new U,Qe=class n extends qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:aM++}),this.uuid=mr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(LS(t)?Va:ka)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new se().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ii.makeRotationFromQuaternion(t),this.applyMatrix4(Ii),this}rotateX(t){return Ii.makeRotationX(t),this.applyMatrix4(Ii),this}rotateY(t){return Ii.makeRotationY(t),this.applyMatrix4(Ii),this}rotateZ(t){return Ii.makeRotationZ(t),this.applyMatrix4(Ii),this}translate(t,e,i){return Ii.makeTranslation(t,e,i),this.applyMatrix4(Ii),this}scale(t,e,i){return Ii.makeScale(t,e,i),this.applyMatrix4(Ii),this}lookAt(t){return cd.lookAt(t),cd.updateMatrix(),this.applyMatrix4(cd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ye(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Jt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Sn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&ee('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new bi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){ee("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(t){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ta.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(_i.min,Ta.min),_i.expandByPoint(Nn),Nn.addVectors(_i.max,Ta.max),_i.expandByPoint(Nn)):(_i.expandByPoint(Ta.min),_i.expandByPoint(Ta.max))}_i.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Nn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Nn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Nn.fromBufferAttribute(a,c),l&&(Mo.fromBufferAttribute(t,c),Nn.add(Mo)),s=Math.max(s,i.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&ee('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){ee("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Un(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let O=0;O<i.count;O++)a[O]=new U,l[O]=new U;let h=new U,u=new U,d=new U,f=new Zt,m=new Zt,_=new Zt,g=new U,p=new U;function v(O,I,L){c[O]=c[I]=c[L]=1,h.fromBufferAttribute(i,O),u.fromBufferAttribute(i,I),d.fromBufferAttribute(i,L),f.fromBufferAttribute(r,O),m.fromBufferAttribute(r,I),_.fromBufferAttribute(r,L),u.sub(h),d.sub(h),m.sub(f),_.sub(f);let z=1/(m.x*_.y-_.x*m.y);isFinite(z)&&(g.copy(u).multiplyScalar(_.y).addScaledVector(d,-m.y).multiplyScalar(z),p.copy(d).multiplyScalar(m.x).addScaledVector(u,-_.x).multiplyScalar(z),a[O].add(g),a[I].add(g),a[L].add(g),l[O].add(p),l[I].add(p),l[L].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:t.count}]);for(let O=0,I=T.length;O<I;++O){let L=T[O],z=L.start,V=L.count;for(let D=z,H=z+V;D<H;D+=3)v(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let S=new U,C=new U,A=new U,x=new U;function E(O){A.fromBufferAttribute(s,O),x.copy(A);let I=a[O];S.copy(I),S.sub(A.multiplyScalar(A.dot(I))).normalize(),C.crossVectors(x,I);let z=C.dot(l[O])<0?-1:1;o.setXYZW(O,S.x,S.y,S.z,z)}for(let O=0,I=i.count;O<I;++O)c[O]&&E(O);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Un(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,h=new U,u=new U;if(t)for(let d=0,f=t.count;d<f;d+=3){let m=t.getX(d+0),_=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,m),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,g),a.add(h),l.add(h),c.add(h),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Nn.fromBufferAttribute(t,e),Nn.normalize(),t.setXYZ(e,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),f=0,m=0;for(let _=0,g=l.length;_<g;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*h;for(let p=0;p<h;p++)d[m++]=c[f++]}return new Un(d,h,u)}if(this.index===null)return Jt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let f=c[u];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ga=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=qd,this.updateRanges=[],this.version=0,this.uuid=mr()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,i){t*=this.stride,i*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[i+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Hm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let i=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Hm(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Hm(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=mr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ti=new U,Di=class n{constructor(t,e,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=i,this.normalized=s,this._normalizationScale=t!==void 0?Wh(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,i=this.data.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.applyMatrix4(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.applyNormalMatrix(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)ti.fromBufferAttribute(this,e),ti.transformDirection(t),this.setXYZ(e,ti.x,ti.y,ti.z);return this}getComponent(t,e){let i=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.data.array[t*this.data.stride+this.offset+e]=i,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,i){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.data.array[t+0]=e,this.data.array[t+1]=i,this}setXYZ(t,e,i,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=i,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){Fa("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new Un(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new n(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){Fa("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jd(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Qd(t,this.data.array)}},hd=new U,lM=new U,cM=new se,yi=class{constructor(t=new U(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=hd.subVectors(i,e).cross(lM.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(hd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||cM.getNormalMatrix(t),s=this.coplanarPoint(hd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},hM=0,ds=class extends qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=mr(),this.name="",this.type="Material",this.blending=Wo,this.side=fr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Rd,this.blendDst=Pd,this.blendEquation=Fr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ne(0,0,0),this.blendAlpha=0,this.depthFunc=Io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Fg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Mc,this.stencilZFail=Mc,this.stencilZPass=Mc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Jt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Jt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new ne().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new yi().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Zt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ds=new U,ud=new U,ec=new U,nc=new U,nr=class{constructor(t=new U,e=new U(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ds)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ds.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ds.copy(this.origin).addScaledVector(this.direction,e),Ds.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){ud.copy(t).add(e).multiplyScalar(.5),ec.copy(e).sub(t).normalize(),nc.copy(this.origin).sub(ud);let r=t.distanceTo(e)*.5,o=-this.direction.dot(ec),a=nc.dot(this.direction),l=-nc.dot(ec),c=nc.lengthSq(),h=Math.abs(1-o*o),u,d,f,m;if(h>0)if(u=o*l-a,d=o*a-l,m=r*h,u>=0)if(d>=-m)if(d<=m){let _=1/h;u*=_,d*=_,f=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;else d<=-m?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c):d<=m?(u=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),f=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ud).addScaledVector(ec,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ds.subVectors(t.center,this.origin);let i=Ds.dot(this.direction),s=Ds.dot(Ds)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Ds)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,m=e.x-o.x,_=e.y-o.y,g=e.z-o.z,p=i.x-o.x,v=i.y-o.y,T=i.z-o.z,S=Math.abs(l),C=Math.abs(c),A=Math.abs(h),x,E,O,I,L,z,V,D,H,$,G,lt;if(S>=C&&S>=A?(O=l,z=u,H=m,lt=p,l>=0?(x=c,E=h,I=d,L=f,V=_,D=g,$=v,G=T):(x=h,E=c,I=f,L=d,V=g,D=_,$=T,G=v)):C>=A?(O=c,z=d,H=_,lt=v,c>=0?(x=h,E=l,I=f,L=u,V=g,D=m,$=T,G=p):(x=l,E=h,I=u,L=f,V=m,D=g,$=p,G=T)):(O=h,z=f,H=g,lt=T,h>=0?(x=l,E=c,I=u,L=d,V=m,D=_,$=p,G=v):(x=c,E=l,I=d,L=u,V=_,D=m,$=v,G=p)),O===0)return null;let Z=x/O,j=E/O,et=1/O,ft=I-Z*z,dt=L-j*z,tt=V-Z*H,gt=D-j*H,yt=$-Z*lt,Ct=G-j*lt,bt=yt*gt-Ct*tt,$t=ft*Ct-dt*yt,ae=tt*dt-gt*ft;if(s){if(bt<0||$t<0||ae<0)return null}else if((bt<0||$t<0||ae<0)&&(bt>0||$t>0||ae>0))return null;let Ht=bt+$t+ae;if(Ht===0)return null;let pe=et*(bt*z+$t*H+ae*lt);return(Ht>0?pe<0:pe>0)?null:this.at(pe/Ht,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Oc=class extends ds{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ne(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new us,this.combine=ih,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Wm=new xe,Rr=new nr,ic=new bi,Xm=new U,sc=new U,rc=new U,oc=new U,dd=new U,ac=new U,$m=new U,lc=new U,Ge=class extends zn{constructor(t=new Qe,e=new Oc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){ac.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(dd.fromBufferAttribute(u,t),o?ac.addScaledVector(dd,h):ac.addScaledVector(dd.sub(e),h))}e.add(ac)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ic.copy(i.boundingSphere),ic.applyMatrix4(r),Rr.copy(t.ray).recast(t.near),!(ic.containsPoint(Rr.origin)===!1&&(Rr.intersectSphere(ic,Xm)===null||Rr.origin.distanceToSquared(Xm)>(t.far-t.near)**2))&&(Wm.copy(r).invert(),Rr.copy(t.ray).applyMatrix4(Wm),!(i.boundingBox!==null&&Rr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Rr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let g=d[m],p=o[g.materialIndex],v=Math.max(g.start,f.start),T=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let S=v,C=T;S<C;S+=3){let A=a.getX(S),x=a.getX(S+1),E=a.getX(S+2);s=cc(this,p,t,i,c,h,u,A,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let g=m,p=_;g<p;g+=3){let v=a.getX(g),T=a.getX(g+1),S=a.getX(g+2);s=cc(this,o,t,i,c,h,u,v,T,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=d.length;m<_;m++){let g=d[m],p=o[g.materialIndex],v=Math.max(g.start,f.start),T=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let S=v,C=T;S<C;S+=3){let A=S,x=S+1,E=S+2;s=cc(this,p,t,i,c,h,u,A,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let m=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let g=m,p=_;g<p;g+=3){let v=g,T=g+1,S=g+2;s=cc(this,o,t,i,c,h,u,v,T,S),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function uM(n,t,e,i,s,r,o,a){let l;if(t.side===ni?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===fr,a),l===null)return null;lc.copy(a),lc.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(lc);return c<e.near||c>e.far?null:{distance:c,point:lc.clone(),object:n}}function cc(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,sc),n.getVertexPosition(l,rc),n.getVertexPosition(c,oc);let h=uM(n,t,e,i,sc,rc,oc,$m);if(h){let u=new U;Ns.getBarycoord($m,sc,rc,oc,u),s&&(h.uv=Ns.getInterpolatedAttribute(s,a,l,c,u,new Zt)),r&&(h.uv1=Ns.getInterpolatedAttribute(r,a,l,c,u,new Zt)),o&&(h.normal=Ns.getInterpolatedAttribute(o,a,l,c,u,new U),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new U,materialIndex:0};Ns.getNormal(sc,rc,oc,d.normal),h.face=d,h.barycoord=u}return h}var Ha=class extends ai{constructor(t=null,e=1,i=1,s,r,o,a,l,c=On,h=On,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Bo=class extends Un{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},bo=new xe,Ym=new xe,hc=[],qm=new Sn,dM=new xe,Ca=new Ge,Ra=new bi,Wa=class extends Ge{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Bo(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,dM)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Sn),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,bo),qm.copy(t.boundingBox).applyMatrix4(bo),this.boundingBox.union(qm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new bi),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,bo),Ra.copy(t.boundingSphere).applyMatrix4(bo),this.boundingSphere.union(Ra)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Ca.geometry=this.geometry,Ca.material=this.material,Ca.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ra.copy(this.boundingSphere),Ra.applyMatrix4(i),t.ray.intersectsSphere(Ra)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,bo),Ym.multiplyMatrices(i,bo),Ca.matrixWorld=Ym,Ca.raycast(t,hc);for(let o=0,a=hc.length;o<a;o++){let l=hc[o];l.instanceId=r,l.object=this,e.push(l)}hc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Bo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ha(new Float32Array(s*this.count),s,this.count,hh,Ui));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Pr=new bi,fM=new Zt(.5,.5),uc=new U,ir=class{constructor(t=new yi,e=new yi,i=new yi,s=new yi,r=new yi,o=new yi){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Li,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],f=r[7],m=r[8],_=r[9],g=r[10],p=r[11],v=r[12],T=r[13],S=r[14],C=r[15];if(s[0].setComponents(c-o,f-h,p-m,C-v).normalize(),s[1].setComponents(c+o,f+h,p+m,C+v).normalize(),s[2].setComponents(c+a,f+u,p+_,C+T).normalize(),s[3].setComponents(c-a,f-u,p-_,C-T).normalize(),i)s[4].setComponents(l,d,g,S).normalize(),s[5].setComponents(c-l,f-d,p-g,C-S).normalize();else if(s[4].setComponents(c-l,f-d,p-g,C-S).normalize(),e===Li)s[5].setComponents(c+l,f+d,p+g,C+S).normalize();else if(e===Lo)s[5].setComponents(l,d,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(t){Pr.center.set(0,0,0);let e=fM.distanceTo(t.center);return Pr.radius=.7071067811865476+e,Pr.applyMatrix4(t.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(uc.x=s.normal.x>0?t.max.x:t.min.x,uc.y=s.normal.y>0?t.max.y:t.min.y,uc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(uc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Zm=new xe,Fc=class n{constructor(){this.coordinateSystem=Li,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Zm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new ir),i[s].setFromProjectionMatrix(Zm,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new ir),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var sr=class extends ds{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ne(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Bc=new U,zc=new U,Jm=new xe,Pa=new nr,dc=new bi,fd=new U,Km=new U,kc=class extends zn{constructor(t=new Qe,e=new sr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Bc.fromBufferAttribute(e,s-1),zc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Bc.distanceTo(zc);t.setAttribute("lineDistance",new ye(i,1))}else Jt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),dc.copy(i.boundingSphere),dc.applyMatrix4(s),dc.radius+=r,t.ray.intersectsSphere(dc)===!1)return;Jm.copy(s).invert(),Pa.copy(t.ray).applyMatrix4(Jm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let _=f,g=m-1;_<g;_+=c){let p=h.getX(_),v=h.getX(_+1),T=fc(this,t,Pa,l,p,v,_);T&&e.push(T)}if(this.isLineLoop){let _=h.getX(m-1),g=h.getX(f),p=fc(this,t,Pa,l,_,g,m-1);p&&e.push(p)}}else{let f=Math.max(0,o.start),m=Math.min(d.count,o.start+o.count);for(let _=f,g=m-1;_<g;_+=c){let p=fc(this,t,Pa,l,_,_+1,_);p&&e.push(p)}if(this.isLineLoop){let _=fc(this,t,Pa,l,m-1,f,m-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function fc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Bc.fromBufferAttribute(a,s),zc.fromBufferAttribute(a,r),e.distanceSqToSegment(Bc,zc,fd,Km)>i)return;fd.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(fd);if(!(c<t.near||c>t.far))return{distance:c,point:Km.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var jm=new U,Qm=new U,Ir=class extends kc{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)jm.fromBufferAttribute(e,s),Qm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+jm.distanceTo(Qm);t.setAttribute("lineDistance",new ye(i,1))}else Jt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Xa=class extends ai{constructor(t=[],e=Br,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Fs=class extends ai{constructor(t,e,i=Ji,s,r,o,a=On,l=On,c,h=Os,u=1){if(h!==Os&&h!==zs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Uo(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},$a=class extends Fs{constructor(t,e=Ji,i=Br,s,r,o=On,a=On,l,c=Os){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Ya=class extends ai{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},zo=class n extends Qe{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,f=0;m("z","y","x",-1,-1,i,e,t,o,r,0),m("z","y","x",1,-1,i,e,-t,o,r,1),m("x","z","y",1,1,t,i,e,s,o,2),m("x","z","y",1,-1,t,i,-e,s,o,3),m("x","y","z",1,-1,t,e,i,s,r,4),m("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ye(c,3)),this.setAttribute("normal",new ye(h,3)),this.setAttribute("uv",new ye(u,2));function m(_,g,p,v,T,S,C,A,x,E,O){let I=S/x,L=C/E,z=S/2,V=C/2,D=A/2,H=x+1,$=E+1,G=0,lt=0,Z=new U;for(let j=0;j<$;j++){let et=j*L-V;for(let ft=0;ft<H;ft++){let dt=ft*I-z;Z[_]=dt*v,Z[g]=et*T,Z[p]=D,c.push(Z.x,Z.y,Z.z),Z[_]=0,Z[g]=0,Z[p]=A>0?1:-1,h.push(Z.x,Z.y,Z.z),u.push(ft/x),u.push(1-j/E),G+=1}}for(let j=0;j<E;j++)for(let et=0;et<x;et++){let ft=d+et+H*j,dt=d+et+H*(j+1),tt=d+(et+1)+H*(j+1),gt=d+(et+1)+H*j;l.push(ft,dt,gt),l.push(dt,tt,gt),lt+=6}a.addGroup(f,lt,O),f+=lt,d+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}},Lr=class n extends Qe{constructor(t=1,e=1,i=4,s=8,r=1){super(),this.type="CapsuleGeometry",this.parameters={radius:t,height:e,capSegments:i,radialSegments:s,heightSegments:r},e=Math.max(0,e),i=Math.max(1,Math.floor(i)),s=Math.max(3,Math.floor(s)),r=Math.max(1,Math.floor(r));let o=[],a=[],l=[],c=[],h=e/2,u=Math.PI/2*t,d=e,f=2*u+d,m=i*2+r,_=s+1,g=new U,p=new U;for(let v=0;v<=m;v++){let T=0,S=0,C=0,A=0;if(v<=i){let O=v/i,I=O*Math.PI/2;S=-h-t*Math.cos(I),C=t*Math.sin(I),A=-t*Math.cos(I),T=O*u}else if(v<=i+r){let O=(v-i)/r;S=-h+O*e,C=t,A=0,T=u+O*d}else{let O=(v-i-r)/i,I=O*Math.PI/2;S=h+t*Math.sin(I),C=t*Math.cos(I),A=t*Math.sin(I),T=u+d+O*u}let x=Math.max(0,Math.min(1,T/f)),E=0;v===0?E=.5/s:v===m&&(E=-.5/s);for(let O=0;O<=s;O++){let I=O/s,L=I*Math.PI*2,z=Math.sin(L),V=Math.cos(L);p.x=-C*V,p.y=S,p.z=C*z,a.push(p.x,p.y,p.z),g.set(-C*V,A,C*z),g.normalize(),l.push(g.x,g.y,g.z),c.push(I+E,x)}if(v>0){let O=(v-1)*_;for(let I=0;I<s;I++){let L=O+I,z=O+I+1,V=v*_+I,D=v*_+I+1;o.push(L,z,V),o.push(z,D,V)}}}this.setIndex(o),this.setAttribute("position",new ye(a,3)),this.setAttribute("normal",new ye(l,3)),this.setAttribute("uv",new ye(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.height,t.capSegments,t.radialSegments,t.heightSegments)}};var rr=class n extends Qe{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],m=0,_=[],g=i/2,p=0;v(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(h),this.setAttribute("position",new ye(u,3)),this.setAttribute("normal",new ye(d,3)),this.setAttribute("uv",new ye(f,2));function v(){let S=new U,C=new U,A=0,x=(e-t)/i;for(let E=0;E<=r;E++){let O=[],I=E/r,L=I*(e-t)+t;for(let z=0;z<=s;z++){let V=z/s,D=V*l+a,H=Math.sin(D),$=Math.cos(D);C.x=L*H,C.y=-I*i+g,C.z=L*$,u.push(C.x,C.y,C.z),S.set(H,x,$).normalize(),d.push(S.x,S.y,S.z),f.push(V,1-I),O.push(m++)}_.push(O)}for(let E=0;E<s;E++)for(let O=0;O<r;O++){let I=_[O][E],L=_[O+1][E],z=_[O+1][E+1],V=_[O][E+1];(t>0||O!==0)&&(h.push(I,L,V),A+=3),(e>0||O!==r-1)&&(h.push(L,z,V),A+=3)}c.addGroup(p,A,0),p+=A}function T(S){let C=m,A=new Zt,x=new U,E=0,O=S===!0?t:e,I=S===!0?1:-1;for(let z=1;z<=s;z++)u.push(0,g*I,0),d.push(0,I,0),f.push(.5,.5),m++;let L=m;for(let z=0;z<=s;z++){let D=z/s*l+a,H=Math.cos(D),$=Math.sin(D);x.x=O*$,x.y=g*I,x.z=O*H,u.push(x.x,x.y,x.z),d.push(0,I,0),A.x=H*.5+.5,A.y=$*.5*I+.5,f.push(A.x,A.y),m++}for(let z=0;z<s;z++){let V=C+z,D=L+z;S===!0?h.push(D,D+1,V):h.push(D+1,D,V),E+=3}c.addGroup(p,E,S===!0?1:2),p+=E}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Dr=class n extends rr{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var pc=new U,mc=new U,pd=new U,gc=new Ns,qa=class extends Qe{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(Ro*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let m=0;m<l;m+=3){o?(c[0]=o.getX(m),c[1]=o.getX(m+1),c[2]=o.getX(m+2)):(c[0]=m,c[1]=m+1,c[2]=m+2);let{a:_,b:g,c:p}=gc;if(_.fromBufferAttribute(a,c[0]),g.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),gc.getNormal(pd),u[0]=`${Math.round(_.x*s)},${Math.round(_.y*s)},${Math.round(_.z*s)}`,u[1]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,u[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let v=0;v<3;v++){let T=(v+1)%3,S=u[v],C=u[T],A=gc[h[v]],x=gc[h[T]],E=`${S}_${C}`,O=`${C}_${S}`,I=d.get(O);I?(pd.dot(I.normal)<=r&&(f.push(A.x,A.y,A.z),f.push(x.x,x.y,x.z)),d.set(O,null)):d.has(E)||d.set(E,{index0:c[v],index1:c[T],normal:pd.clone()})}}for(let m of d.values())if(m){let{index0:_,index1:g}=m;pc.fromBufferAttribute(a,_),mc.fromBufferAttribute(a,g),f.push(pc.x,pc.y,pc.z),f.push(mc.x,mc.y,mc.z)}this.setAttribute("position",new ye(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var Za=class n extends Qe{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,f=[],m=[],_=[],g=[];for(let p=0;p<h;p++){let v=p*d-o;for(let T=0;T<c;T++){let S=T*u-r;m.push(S,-v,0),_.push(0,0,1),g.push(T/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let T=v+c*p,S=v+c*(p+1),C=v+1+c*(p+1),A=v+1+c*p;f.push(T,S,A),f.push(S,C,A)}this.setIndex(f),this.setAttribute("position",new ye(m,3)),this.setAttribute("normal",new ye(_,3)),this.setAttribute("uv",new ye(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var or=class n extends Qe{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new U,d=new U,f=[],m=[],_=[],g=[];for(let p=0;p<=i;p++){let v=[],T=p/i,S=o+T*a,C=t*Math.cos(S),A=Math.sqrt(t*t-C*C),x=0;p===0&&o===0?x=.5/e:p===i&&l===Math.PI&&(x=-.5/e);for(let E=0;E<=e;E++){let O=E/e,I=s+O*r;u.x=-A*Math.cos(I),u.y=C,u.z=A*Math.sin(I),m.push(u.x,u.y,u.z),d.copy(u).normalize(),_.push(d.x,d.y,d.z),g.push(O+x,1-T),v.push(c++)}h.push(v)}for(let p=0;p<i;p++)for(let v=0;v<e;v++){let T=h[p][v+1],S=h[p][v],C=h[p+1][v],A=h[p+1][v+1];(p!==0||o>0)&&f.push(T,S,A),(p!==i-1||l<Math.PI)&&f.push(S,C,A)}this.setIndex(f),this.setAttribute("position",new ye(m,3)),this.setAttribute("normal",new ye(_,3)),this.setAttribute("uv",new ye(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ja=class n extends Qe{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},i=Math.floor(i),s=Math.floor(s);let l=[],c=[],h=[],u=[],d=new U,f=new U,m=new U;for(let _=0;_<=i;_++){let g=o+_/i*a;for(let p=0;p<=s;p++){let v=p/s*r;f.x=(t+e*Math.cos(g))*Math.cos(v),f.y=(t+e*Math.cos(g))*Math.sin(v),f.z=e*Math.sin(g),c.push(f.x,f.y,f.z),d.x=t*Math.cos(v),d.y=t*Math.sin(v),m.subVectors(f,d).normalize(),h.push(m.x,m.y,m.z),u.push(p/s),u.push(_/i)}}for(let _=1;_<=i;_++)for(let g=1;g<=s;g++){let p=(s+1)*_+g-1,v=(s+1)*(_-1)+g-1,T=(s+1)*(_-1)+g,S=(s+1)*_+g;l.push(p,v,S),l.push(v,T,S)}this.setIndex(l),this.setAttribute("position",new ye(c,3)),this.setAttribute("normal",new ye(h,3)),this.setAttribute("uv",new ye(u,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc,t.thetaStart,t.thetaLength)}};var Ka=class extends Qe{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],i=new Set,s=new U,r=new U;if(t.index!==null){let o=t.attributes.position,a=t.index,l=t.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,h=l.length;c<h;++c){let u=l[c],d=u.start,f=u.count;for(let m=d,_=d+f;m<_;m+=3)for(let g=0;g<3;g++){let p=a.getX(m+g),v=a.getX(m+(g+1)%3);s.fromBufferAttribute(o,p),r.fromBufferAttribute(o,v),tg(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let h=3*a+c,u=3*a+(c+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),tg(s,r,i)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new ye(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function tg(n,t,e){let i=`${n.x},${n.y},${n.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${n.x},${n.y},${n.z}`;return e.has(i)===!0||e.has(s)===!0?!1:(e.add(i),e.add(s),!0)}function kr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(eg(s))s.isRenderTargetTexture?(Jt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(eg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Yn(n){let t={};for(let e=0;e<n.length;e++){let i=kr(n[e]);for(let s in i)t[s]=i[s]}return t}function eg(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function pM(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function tf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Se.workingColorSpace}var gl={clone:kr,merge:Yn},mM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,gM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ni=class extends ds{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=mM,this.fragmentShader=gM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=kr(t.uniforms),this.uniformsGroups=pM(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new ne().setHex(s.value);break;case"v2":this.uniforms[i].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new U().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Pe().fromArray(s.value);break;case"m3":this.uniforms[i].value=new se().fromArray(s.value);break;case"m4":this.uniforms[i].value=new xe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Vc=class extends Ni{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ja=class extends ds{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ne(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ne(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ml,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new us,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Zi=class extends ds{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ne(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ne(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ml,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new us,this.combine=ih,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},Gc=class extends ds{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ug,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Hc=class extends ds{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function wo(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function _c(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ar=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Wc=class extends ar{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:xd,endingEnd:xd}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case yd:r=t,a=2*e-i;break;case vd:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case yd:o=t,l=2*i-e;break;case vd:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-e)/(s-e),_=m*m,g=_*m,p=-d*g+2*d*_-d*m,v=(1+d)*g+(-1.5-2*d)*_+(-.5+d)*m+1,T=(-1-f)*g+(1.5+f)*_+.5*m,S=f*g-f*_;for(let C=0;C!==a;++C)r[C]=p*o[h+C]+v*o[c+C]+T*o[l+C]+S*o[u+C];return r}},Xc=class extends ar{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},$c=class extends ar{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Yc=class extends ar{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let m=(i-e)/(s-e),_=1-m;for(let g=0;g!==a;++g)r[g]=o[c+g]*_+o[l+g]*m;return r}let d=a*2,f=t-1;for(let m=0;m!==a;++m){let _=o[c+m],g=o[l+m],p=f*d+m*2,v=u[p],T=u[p+1],S=t*d+m*2,C=h[S],A=h[S+1],x=xM(i,e,v,C,s);r[m]=qg(x,_,T,A,g)}return r}};function qg(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function _M(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function xM(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=qg(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=_M(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var wi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=wo(e,this.TimeBufferType),this.values=wo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:wo(t.times,Array),values:wo(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),_c(t.settings)&&(i.settings={inTangents:wo(t.settings.inTangents,Array),outTangents:wo(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new $c(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Xc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Wc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Yc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Da:e=this.InterpolantFactoryMethodDiscrete;break;case Lc:e=this.InterpolantFactoryMethodLinear;break;case Sc:e=this.InterpolantFactoryMethodSmooth;break;case _d:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Jt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Da;case this.InterpolantFactoryMethodLinear:return Lc;case this.InterpolantFactoryMethodSmooth:return Sc;case this.InterpolantFactoryMethodBezier:return _d}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;_c(this.settings)&&(ng(this.settings.inTangents,t),ng(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;_c(this.settings)&&(ig(this.settings.inTangents,t),ig(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(ee("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(ee("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){ee("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){ee("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&DS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){ee("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Sc,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,d=u-i,f=u+i;for(let m=0;m!==i;++m){let _=e[u+m];if(_!==e[d+m]||_!==e[f+m]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,_c(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function ng(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function ig(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}wi.prototype.ValueTypeName="";wi.prototype.TimeBufferType=Float32Array;wi.prototype.ValueBufferType=Float32Array;wi.prototype.DefaultInterpolation=Lc;var lr=class extends wi{constructor(t,e,i){super(t,e,i)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Da;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var qc=class extends wi{constructor(t,e,i,s){super(t,e,i,s)}};qc.prototype.ValueTypeName="color";var Zc=class extends wi{constructor(t,e,i,s){super(t,e,i,s)}};Zc.prototype.ValueTypeName="number";var Jc=class extends ar{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)Si.slerpFlat(r,0,o,c-a,o,c,l);return r}},Qa=class extends wi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Jc(this.times,this.values,this.getValueSize(),t)}};Qa.prototype.ValueTypeName="quaternion";Qa.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends wi{constructor(t,e,i){super(t,e,i)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Da;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var Kc=class extends wi{constructor(t,e,i,s){super(t,e,i,s)}};Kc.prototype.ValueTypeName="vector";var jc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let f=c[u],m=c[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Zg=new jc,Qc=class{constructor(t){this.manager=t!==void 0?t:Zg,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Qc.DEFAULT_MATERIAL_NAME="__DEFAULT";var tl=class extends zn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new ne(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},el=class extends tl{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(zn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ne(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},md=new xe,sg=new U,rg=new U,th=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=li,this.map=null,this.mapPass=null,this.matrix=new xe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new ir,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new Pe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;sg.setFromMatrixPosition(t.matrixWorld),e.position.copy(sg),rg.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(rg),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){md.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(md,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Lo||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(md)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},xc=new U,yc=new Si,cs=new U,nl=class extends zn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new xe,this.projectionMatrix=new xe,this.projectionMatrixInverse=new xe,this.coordinateSystem=Li,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(xc,yc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xc,yc,cs.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(xc,yc,cs),cs.x===1&&cs.y===1&&cs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(xc,yc,cs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},er=new U,og=new Zt,ag=new Zt,vi=class extends nl{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=No*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Ro*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return No*2*Math.atan(Math.tan(Ro*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){er.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(er.x,er.y).multiplyScalar(-t/er.z),er.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(er.x,er.y).multiplyScalar(-t/er.z)}getViewSize(t,e){return this.getViewBounds(t,og,ag),e.subVectors(ag,og)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Ro*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Nr=class extends nl{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Sd=class extends th{constructor(){super(new Nr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},ko=class extends tl{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(zn.DEFAULT_UP),this.updateMatrix(),this.target=new zn,this.shadow=new Sd}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var il=class extends Qe{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var Eo=-90,Ao=1,Vo=class extends zn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new vi(Eo,Ao,t,e);s.layers=this.layers,this.add(s);let r=new vi(Eo,Ao,t,e);r.layers=this.layers,this.add(r);let o=new vi(Eo,Ao,t,e);o.layers=this.layers,this.add(o);let a=new vi(Eo,Ao,t,e);a.layers=this.layers,this.add(a);let l=new vi(Eo,Ao,t,e);l.layers=this.layers,this.add(l);let c=new vi(Eo,Ao,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Li)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Lo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},eh=class extends vi{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var ef="\\[\\]\\.:\\/",yM=new RegExp("["+ef+"]","g"),nf="[^"+ef+"]",vM="[^"+ef.replace("\\.","")+"]",SM=/((?:WC+[\/:])*)/.source.replace("WC",nf),MM=/(WCOD+)?/.source.replace("WCOD",vM),bM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",nf),wM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",nf),EM=new RegExp("^"+SM+MM+bM+wM+"$"),AM=["material","materials","bones","map"],Md=class{constructor(t,e,i){let s=i||Ye.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ye=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(yM,"")}static parseTrackName(t){let e=EM.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);AM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Jt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){ee("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){ee("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){ee("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){ee("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){ee("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){ee("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;ee("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){ee("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ye.Composite=Md;Ye.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ye.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ye.prototype.GetterByBindingType=[Ye.prototype._getValue_direct,Ye.prototype._getValue_array,Ye.prototype._getValue_arrayElement,Ye.prototype._getValue_toArray];Ye.prototype.SetterByBindingTypeAndVersioning=[[Ye.prototype._setValue_direct,Ye.prototype._setValue_direct_setNeedsUpdate,Ye.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_array,Ye.prototype._setValue_array_setNeedsUpdate,Ye.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_arrayElement,Ye.prototype._setValue_arrayElement_setNeedsUpdate,Ye.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ye.prototype._setValue_fromArray,Ye.prototype._setValue_fromArray_setNeedsUpdate,Ye.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nL=new Float32Array(1);var hr=class extends Ga{constructor(t,e,i=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var lg=new xe,sl=class{constructor(t,e,i=0,s=1/0){this.ray=new nr(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Oo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):ee("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return lg.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(lg),this}intersectObject(t,e=!0,i=[]){return bd(t,this,i,e),i.sort(cg),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)bd(t[s],this,i,e);return i.sort(cg),i}};function cg(n,t){return n.distance-t.distance}function bd(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)bd(r[o],t,e,!0)}}var Go=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=ce(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(ce(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var cf=class cf{constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};cf.prototype.isMatrix2=!0;var wd=cf;var hg=new U,vc=new U,To=new U,Co=new U,gd=new U,TM=new U,CM=new U,rl=class{constructor(t=new U,e=new U){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){hg.subVectors(t,this.start),vc.subVectors(this.end,this.start);let i=vc.dot(vc);if(i===0)return 0;let r=vc.dot(hg)/i;return e&&(r=ce(r,0,1)),r}closestPointToPoint(t,e,i){let s=this.closestPointToPointParameter(t,e);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=TM,i=CM){let s=10000000000000001e-32,r,o,a=this.start,l=t.start,c=this.end,h=t.end;To.subVectors(c,a),Co.subVectors(h,l),gd.subVectors(a,l);let u=To.dot(To),d=Co.dot(Co),f=Co.dot(gd);if(u<=s&&d<=s)return e.copy(a),i.copy(l),e.distanceToSquared(i);if(u<=s)r=0,o=f/d,o=ce(o,0,1);else{let m=To.dot(gd);if(d<=s)o=0,r=ce(-m/u,0,1);else{let _=To.dot(Co),g=u*d-_*_;g!==0?r=ce((_*f-m*d)/g,0,1):r=0,o=(_*r+f)/d,o<0?(o=0,r=ce(-m/u,0,1)):o>1&&(o=1,r=ce((_-m)/u,0,1))}}return e.copy(a).addScaledVector(To,r),i.copy(l).addScaledVector(Co,o),e.distanceToSquared(i)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var ol=class extends Ir{constructor(t=10,e=10,i=4473924,s=8947848){i=new ne(i),s=new ne(s);let r=e/2,o=t/e,a=t/2,l=[],c=[];for(let d=0,f=0,m=-a;d<=e;d++,m+=o){l.push(-a,0,m,a,0,m),l.push(m,0,-a,m,0,a);let _=d===r?i:s;_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3,_.toArray(c,f),f+=3}let h=new Qe;h.setAttribute("position",new ye(l,3)),h.setAttribute("color",new ye(c,3));let u=new sr({vertexColors:!0,toneMapped:!1});super(h,u),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};var al=class extends qi{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function sf(n,t,e,i){let s=RM(i);switch(e){case Hd:return n*t;case hh:return n*t/s.components*s.byteLength;case uh:return n*t/s.components*s.byteLength;case pr:return n*t*2/s.components*s.byteLength;case dh:return n*t*2/s.components*s.byteLength;case Wd:return n*t*3/s.components*s.byteLength;case ji:return n*t*4/s.components*s.byteLength;case fh:return n*t*4/s.components*s.byteLength;case cl:case hl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ul:case dl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case mh:case _h:return Math.max(n,16)*Math.max(t,8)/4;case ph:case gh:return Math.max(n,8)*Math.max(t,8)/2;case xh:case yh:case Sh:case Mh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case vh:case fl:case bh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case wh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Eh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Ah:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Th:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Ch:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Rh:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ph:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Ih:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Lh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Dh:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Nh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Uh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Oh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Fh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Bh:case zh:case kh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Vh:case Gh:return Math.ceil(n/4)*Math.ceil(t/4)*8;case pl:case Hh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function RM(n){switch(n){case li:case zd:return{byteLength:1,components:1};case $o:case kd:case Ki:return{byteLength:2,components:1};case lh:case ch:return{byteLength:2,components:4};case Ji:case ah:case Ui:return{byteLength:4,components:1};case Vd:case Gd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Jt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function _0(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function NM(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<u.length;f++){let m=u[d],_=u[f];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++d,u[d]=_)}u.length=d+1;for(let f=0,m=u.length;f<m;f++){let _=u[f];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var UM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,OM=`#ifdef USE_ALPHAHASH
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
#endif`,FM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,BM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,zM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,kM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,VM=`#ifdef USE_AOMAP
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
#endif`,GM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,HM=`#ifdef USE_BATCHING
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
#endif`,WM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,XM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,$M=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,YM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,qM=`#ifdef USE_IRIDESCENCE
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
#endif`,ZM=`#ifdef USE_BUMPMAP
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
#endif`,JM=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,KM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,jM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,QM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,tb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,eb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,nb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ib=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,sb=`#define PI 3.141592653589793
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
} // validated`,rb=`vec3 transformedNormal = objectNormal;
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
#endif`,ob=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ab=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,lb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,cb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,hb="gl_FragColor = linearToOutputTexel( gl_FragColor );",ub=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,db=`#ifdef USE_ENVMAP
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
#endif`,fb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,pb=`#ifdef USE_ENVMAP
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
#endif`,mb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,gb=`#ifdef USE_ENVMAP
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
#endif`,_b=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,xb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,yb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,vb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Sb=`#ifdef USE_GRADIENTMAP
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
}`,Mb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,bb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,wb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Eb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Ab=`#ifdef USE_ENVMAP
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
#endif`,Tb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Cb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Rb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Pb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ib=`PhysicalMaterial material;
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
#endif`,Lb=`uniform sampler2D dfgLUT;
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
}`,Db=`
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
#endif`,Nb=`#if defined( RE_IndirectDiffuse )
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
#endif`,Ub=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ob=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Fb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Bb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,kb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Vb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Gb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Hb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Wb=`#if defined( USE_POINTS_UV )
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
#endif`,Xb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,$b=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Yb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,qb=`#if defined( USE_MORPHCOLORS )
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
#endif`,Zb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Jb=`#ifdef USE_MORPHTARGETS
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
#endif`,Kb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Qb=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,tw=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ew=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,nw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,iw=`#ifdef USE_NORMALMAP
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
#endif`,sw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,rw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ow=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,aw=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,lw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,cw=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,hw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,uw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,fw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,pw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,mw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,gw=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,_w=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,xw=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,yw=`float getShadowMask() {
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
}`,vw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Sw=`#ifdef USE_SKINNING
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
#endif`,Mw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,bw=`#ifdef USE_SKINNING
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
#endif`,ww=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Ew=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Aw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Tw=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Cw=`#ifdef USE_TRANSMISSION
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
#endif`,Rw=`#ifdef USE_TRANSMISSION
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
#endif`,Pw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Iw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Lw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Dw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Nw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Uw=`uniform sampler2D t2D;
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
}`,Ow=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Fw=`uniform float backgroundBlurriness;
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
}`,Bw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,zw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kw=`#include <common>
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
}`,Vw=`#if DEPTH_PACKING == 3200
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
}`,Gw=`#define DISTANCE
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
}`,Hw=`#define DISTANCE
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
}`,Ww=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Xw=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$w=`uniform float scale;
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
}`,Yw=`uniform vec3 diffuse;
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
}`,qw=`#include <common>
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
}`,Zw=`uniform vec3 diffuse;
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
}`,Jw=`#define LAMBERT
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
}`,Kw=`#define LAMBERT
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
}`,jw=`#define MATCAP
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
}`,Qw=`#define MATCAP
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
}`,tE=`#define NORMAL
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
}`,eE=`#define NORMAL
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
}`,nE=`#define PHONG
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
}`,iE=`#define PHONG
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
}`,sE=`#define STANDARD
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
}`,rE=`#define STANDARD
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
}`,oE=`#define TOON
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
}`,aE=`#define TOON
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
}`,lE=`uniform float size;
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
}`,cE=`uniform vec3 diffuse;
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
}`,hE=`#include <common>
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
}`,uE=`uniform vec3 color;
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
}`,dE=`uniform float rotation;
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
}`,fE=`uniform vec3 diffuse;
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
}`,fe={alphahash_fragment:UM,alphahash_pars_fragment:OM,alphamap_fragment:FM,alphamap_pars_fragment:BM,alphatest_fragment:zM,alphatest_pars_fragment:kM,aomap_fragment:VM,aomap_pars_fragment:GM,batching_pars_vertex:HM,batching_vertex:WM,begin_vertex:XM,beginnormal_vertex:$M,bsdfs:YM,iridescence_fragment:qM,bumpmap_pars_fragment:ZM,clipping_planes_fragment:JM,clipping_planes_pars_fragment:KM,clipping_planes_pars_vertex:jM,clipping_planes_vertex:QM,color_fragment:tb,color_pars_fragment:eb,color_pars_vertex:nb,color_vertex:ib,common:sb,defaultnormal_vertex:rb,displacementmap_pars_vertex:ob,displacementmap_vertex:ab,emissivemap_fragment:lb,emissivemap_pars_fragment:cb,colorspace_fragment:hb,colorspace_pars_fragment:ub,envmap_fragment:db,envmap_common_pars_fragment:fb,envmap_pars_fragment:pb,envmap_pars_vertex:mb,envmap_physical_pars_fragment:Ab,envmap_vertex:gb,fog_vertex:_b,fog_pars_vertex:xb,fog_fragment:yb,fog_pars_fragment:vb,gradientmap_pars_fragment:Sb,lightmap_pars_fragment:Mb,lights_lambert_fragment:bb,lights_lambert_pars_fragment:wb,lights_pars_begin:Eb,lights_toon_fragment:Tb,lights_toon_pars_fragment:Cb,lights_phong_fragment:Rb,lights_phong_pars_fragment:Pb,lights_physical_fragment:Ib,lights_physical_pars_fragment:Lb,lights_fragment_begin:Db,lights_fragment_maps:Nb,lights_fragment_end:Ub,lightprobes_pars_fragment:Ob,logdepthbuf_fragment:Fb,logdepthbuf_pars_fragment:Bb,logdepthbuf_pars_vertex:zb,logdepthbuf_vertex:kb,map_fragment:Vb,map_pars_fragment:Gb,map_particle_fragment:Hb,map_particle_pars_fragment:Wb,metalnessmap_fragment:Xb,metalnessmap_pars_fragment:$b,morphinstance_vertex:Yb,morphcolor_vertex:qb,morphnormal_vertex:Zb,morphtarget_pars_vertex:Jb,morphtarget_vertex:Kb,normal_fragment_begin:jb,normal_fragment_maps:Qb,normal_pars_fragment:tw,normal_pars_vertex:ew,normal_vertex:nw,normalmap_pars_fragment:iw,clearcoat_normal_fragment_begin:sw,clearcoat_normal_fragment_maps:rw,clearcoat_pars_fragment:ow,iridescence_pars_fragment:aw,opaque_fragment:lw,packing:cw,premultiplied_alpha_fragment:hw,project_vertex:uw,dithering_fragment:dw,dithering_pars_fragment:fw,roughnessmap_fragment:pw,roughnessmap_pars_fragment:mw,shadowmap_pars_fragment:gw,shadowmap_pars_vertex:_w,shadowmap_vertex:xw,shadowmask_pars_fragment:yw,skinbase_vertex:vw,skinning_pars_vertex:Sw,skinning_vertex:Mw,skinnormal_vertex:bw,specularmap_fragment:ww,specularmap_pars_fragment:Ew,tonemapping_fragment:Aw,tonemapping_pars_fragment:Tw,transmission_fragment:Cw,transmission_pars_fragment:Rw,uv_pars_fragment:Pw,uv_pars_vertex:Iw,uv_vertex:Lw,worldpos_vertex:Dw,background_vert:Nw,background_frag:Uw,backgroundCube_vert:Ow,backgroundCube_frag:Fw,cube_vert:Bw,cube_frag:zw,depth_vert:kw,depth_frag:Vw,distance_vert:Gw,distance_frag:Hw,equirect_vert:Ww,equirect_frag:Xw,linedashed_vert:$w,linedashed_frag:Yw,meshbasic_vert:qw,meshbasic_frag:Zw,meshlambert_vert:Jw,meshlambert_frag:Kw,meshmatcap_vert:jw,meshmatcap_frag:Qw,meshnormal_vert:tE,meshnormal_frag:eE,meshphong_vert:nE,meshphong_frag:iE,meshphysical_vert:sE,meshphysical_frag:rE,meshtoon_vert:oE,meshtoon_frag:aE,points_vert:lE,points_frag:cE,shadow_vert:hE,shadow_frag:uE,sprite_vert:dE,sprite_frag:fE},It={common:{diffuse:{value:new ne(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new se}},envmap:{envMap:{value:null},envMapRotation:{value:new se},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new se}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new se}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new se},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new se},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new se},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new se}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new se}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new se}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ne(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ne(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0},uvTransform:{value:new se}},sprite:{diffuse:{value:new ne(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new se},alphaMap:{value:null},alphaMapTransform:{value:new se},alphaTest:{value:0}}},ii={basic:{uniforms:Yn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.fog]),vertexShader:fe.meshbasic_vert,fragmentShader:fe.meshbasic_frag},lambert:{uniforms:Yn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new ne(0)},envMapIntensity:{value:1}}]),vertexShader:fe.meshlambert_vert,fragmentShader:fe.meshlambert_frag},phong:{uniforms:Yn([It.common,It.specularmap,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.fog,It.lights,{emissive:{value:new ne(0)},specular:{value:new ne(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:fe.meshphong_vert,fragmentShader:fe.meshphong_frag},standard:{uniforms:Yn([It.common,It.envmap,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.roughnessmap,It.metalnessmap,It.fog,It.lights,{emissive:{value:new ne(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag},toon:{uniforms:Yn([It.common,It.aomap,It.lightmap,It.emissivemap,It.bumpmap,It.normalmap,It.displacementmap,It.gradientmap,It.fog,It.lights,{emissive:{value:new ne(0)}}]),vertexShader:fe.meshtoon_vert,fragmentShader:fe.meshtoon_frag},matcap:{uniforms:Yn([It.common,It.bumpmap,It.normalmap,It.displacementmap,It.fog,{matcap:{value:null}}]),vertexShader:fe.meshmatcap_vert,fragmentShader:fe.meshmatcap_frag},points:{uniforms:Yn([It.points,It.fog]),vertexShader:fe.points_vert,fragmentShader:fe.points_frag},dashed:{uniforms:Yn([It.common,It.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:fe.linedashed_vert,fragmentShader:fe.linedashed_frag},depth:{uniforms:Yn([It.common,It.displacementmap]),vertexShader:fe.depth_vert,fragmentShader:fe.depth_frag},normal:{uniforms:Yn([It.common,It.bumpmap,It.normalmap,It.displacementmap,{opacity:{value:1}}]),vertexShader:fe.meshnormal_vert,fragmentShader:fe.meshnormal_frag},sprite:{uniforms:Yn([It.sprite,It.fog]),vertexShader:fe.sprite_vert,fragmentShader:fe.sprite_frag},background:{uniforms:{uvTransform:{value:new se},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:fe.background_vert,fragmentShader:fe.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new se}},vertexShader:fe.backgroundCube_vert,fragmentShader:fe.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:fe.cube_vert,fragmentShader:fe.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:fe.equirect_vert,fragmentShader:fe.equirect_frag},distance:{uniforms:Yn([It.common,It.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:fe.distance_vert,fragmentShader:fe.distance_frag},shadow:{uniforms:Yn([It.lights,It.fog,{color:{value:new ne(0)},opacity:{value:1}}]),vertexShader:fe.shadow_vert,fragmentShader:fe.shadow_frag}};ii.physical={uniforms:Yn([ii.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new se},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new se},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new se},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new se},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new se},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new se},sheen:{value:0},sheenColor:{value:new ne(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new se},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new se},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new se},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new se},attenuationDistance:{value:0},attenuationColor:{value:new ne(0)},specularColor:{value:new ne(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new se},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new se},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new se}}]),vertexShader:fe.meshphysical_vert,fragmentShader:fe.meshphysical_frag};var Xh={r:0,b:0,g:0},pE=new xe,x0=new se;x0.set(-1,0,0,0,1,0,0,0,1);function mE(n,t,e,i,s,r){let o=new ne(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function f(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let S=v.backgroundBlurriness>0;T=t.get(T,S)}return T}function m(v){let T=!1,S=f(v);S===null?g(o,a):S&&S.isColor&&(g(S,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?e.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||T)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(v,T){let S=f(T);S&&S.isCubeTexture?(c===void 0&&(c=new Ge(new zo(1,1,1),new Ni({name:"BackgroundCubeMaterial",uniforms:kr(ii.backgroundCube.uniforms),vertexShader:ii.backgroundCube.vertexShader,fragmentShader:ii.backgroundCube.fragmentShader,side:ni,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(pE.makeRotationFromEuler(T.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(x0),c.material.toneMapped=Se.getTransfer(S.colorSpace)!==Re,(h!==S||u!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Ge(new Za(2,2),new Ni({name:"BackgroundMaterial",uniforms:kr(ii.background.uniforms),vertexShader:ii.background.vertexShader,fragmentShader:ii.background.fragmentShader,side:fr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Se.getTransfer(S.colorSpace)!==Re,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||u!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,u=S.version,d=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,T){v.getRGB(Xh,tf(n)),e.buffers.color.setClear(Xh.r,Xh.g,Xh.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:m,addToRenderList:_,dispose:p}}function gE(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(L,z,V,D,H){let $=!1,G=u(L,D,V,z);r!==G&&(r=G,c(r.object)),$=f(L,D,V,H),$&&m(L,D,V,H),H!==null&&t.update(H,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(L,z,V,D),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function h(L){return n.deleteVertexArray(L)}function u(L,z,V,D){let H=D.wireframe===!0,$=i[z.id];$===void 0&&($={},i[z.id]=$);let G=L.isInstancedMesh===!0?L.id:0,lt=$[G];lt===void 0&&(lt={},$[G]=lt);let Z=lt[V.id];Z===void 0&&(Z={},lt[V.id]=Z);let j=Z[H];return j===void 0&&(j=d(l()),Z[H]=j),j}function d(L){let z=[],V=[],D=[];for(let H=0;H<e;H++)z[H]=0,V[H]=0,D[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:V,attributeDivisors:D,object:L,attributes:{},index:null}}function f(L,z,V,D){let H=r.attributes,$=z.attributes,G=0,lt=V.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let et=H[Z],ft=$[Z];if(ft===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(ft=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(ft=L.instanceColor)),et===void 0||et.attribute!==ft||ft&&et.data!==ft.data)return!0;G++}return r.attributesNum!==G||r.index!==D}function m(L,z,V,D){let H={},$=z.attributes,G=0,lt=V.getAttributes();for(let Z in lt)if(lt[Z].location>=0){let et=$[Z];et===void 0&&(Z==="instanceMatrix"&&L.instanceMatrix&&(et=L.instanceMatrix),Z==="instanceColor"&&L.instanceColor&&(et=L.instanceColor));let ft={};ft.attribute=et,et&&et.data&&(ft.data=et.data),H[Z]=ft,G++}r.attributes=H,r.attributesNum=G,r.index=D}function _(){let L=r.newAttributes;for(let z=0,V=L.length;z<V;z++)L[z]=0}function g(L){p(L,0)}function p(L,z){let V=r.newAttributes,D=r.enabledAttributes,H=r.attributeDivisors;V[L]=1,D[L]===0&&(n.enableVertexAttribArray(L),D[L]=1),H[L]!==z&&(n.vertexAttribDivisor(L,z),H[L]=z)}function v(){let L=r.newAttributes,z=r.enabledAttributes;for(let V=0,D=z.length;V<D;V++)z[V]!==L[V]&&(n.disableVertexAttribArray(V),z[V]=0)}function T(L,z,V,D,H,$,G){G===!0?n.vertexAttribIPointer(L,z,V,H,$):n.vertexAttribPointer(L,z,V,D,H,$)}function S(L,z,V,D){_();let H=D.attributes,$=V.getAttributes(),G=z.defaultAttributeValues;for(let lt in $){let Z=$[lt];if(Z.location>=0){let j=H[lt];if(j===void 0&&(lt==="instanceMatrix"&&L.instanceMatrix&&(j=L.instanceMatrix),lt==="instanceColor"&&L.instanceColor&&(j=L.instanceColor)),j!==void 0){let et=j.normalized,ft=j.itemSize,dt=t.get(j);if(dt===void 0)continue;let tt=dt.buffer,gt=dt.type,yt=dt.bytesPerElement,Ct=gt===n.INT||gt===n.UNSIGNED_INT||j.gpuType===ah;if(j.isInterleavedBufferAttribute){let bt=j.data,$t=bt.isInterleavedBuffer===!0?bt.stride:bt.itemSize,ae=j.offset;if(bt.isInstancedInterleavedBuffer||bt.isInstancedBufferAttribute){for(let Ht=0;Ht<Z.locationSize;Ht++)p(Z.location+Ht,bt.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=bt.meshPerAttribute*bt.count)}else for(let Ht=0;Ht<Z.locationSize;Ht++)g(Z.location+Ht);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Ht=0;Ht<Z.locationSize;Ht++)T(Z.location+Ht,ft/Z.locationSize,gt,et,$t*yt,(ae+ft/Z.locationSize*Ht)*yt,Ct)}else{if(j.isInstancedBufferAttribute){for(let bt=0;bt<Z.locationSize;bt++)p(Z.location+bt,j.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let bt=0;bt<Z.locationSize;bt++)g(Z.location+bt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let bt=0;bt<Z.locationSize;bt++)T(Z.location+bt,ft/Z.locationSize,gt,et,ft*yt,ft/Z.locationSize*bt*yt,Ct)}}else if(G!==void 0){let et=G[lt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv(Z.location,et);break;case 3:n.vertexAttrib3fv(Z.location,et);break;case 4:n.vertexAttrib4fv(Z.location,et);break;default:n.vertexAttrib1fv(Z.location,et)}}}}v()}function C(){O();for(let L in i){let z=i[L];for(let V in z){let D=z[V];for(let H in D){let $=D[H];for(let G in $)h($[G].object),delete $[G];delete D[H]}}delete i[L]}}function A(L){if(i[L.id]===void 0)return;let z=i[L.id];for(let V in z){let D=z[V];for(let H in D){let $=D[H];for(let G in $)h($[G].object),delete $[G];delete D[H]}}delete i[L.id]}function x(L){for(let z in i){let V=i[z];for(let D in V){let H=V[D];if(H[L.id]===void 0)continue;let $=H[L.id];for(let G in $)h($[G].object),delete $[G];delete H[L.id]}}}function E(L){for(let z in i){let V=i[z],D=L.isInstancedMesh===!0?L.id:0,H=V[D];if(H!==void 0){for(let $ in H){let G=H[$];for(let lt in G)h(G[lt].object),delete G[lt];delete H[$]}delete V[D],Object.keys(V).length===0&&delete i[z]}}}function O(){I(),o=!0,r!==s&&(r=s,c(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:A,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:g,disableUnusedAttributes:v}}function _E(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let f=0;f<h;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function xE(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==ji&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===Ki&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==li&&x!==Ui&&!E&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Jt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Jt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Jt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),A=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:S,maxSamples:C,samples:A}}function yE(n){let t=this,e=null,i=0,s=!1,r=!1,o=new yi,a=new se,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let m=u.clippingPlanes,_=u.clipIntersection,g=u.clipShadows,p=n.get(u);if(!s||m===null||m.length===0||r&&!g)r?h(null):c();else{let v=r?0:i,T=v*4,S=p.clippingState||null;l.value=S,S=h(m,d,T,f);for(let C=0;C!==T;++C)S[C]=e[C];p.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,m){let _=u!==null?u.length:0,g=null;if(_!==0){if(g=l.value,m!==!0||g===null){let p=f+_*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<p)&&(g=new Float32Array(p));for(let T=0,S=f;T!==_;++T,S+=4)o.copy(u[T]).applyMatrix4(v,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,g}}var yl=class extends Mi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Xa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new zo(5,5,5),r=new Ni({name:"CubemapFromEquirect",uniforms:kr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ni,blending:Or});r.uniforms.tEquirect.value=e;let o=new Ge(s,r),a=e.minFilter;return e.minFilter===Bs&&(e.minFilter=ei),new Vo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Jg=256,vE=3,SE=20,y0=256,v0=16,ME=3,bE=new U,wE=new ne,Yh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Vo(1,10,null),this._boxMesh=new Ge(new zo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=bE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(wE));let g=new Vo(i,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Qg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=jg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Jg,Kd(t))}_fromTexture(t,e){t.mapping===Br||t.mapping===Xo?this._setSize(t.image.length===0?Jg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Kg(t,!1,!1),i=Math.log2(t)-vE;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Kg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Br||t.mapping===Xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=Qg()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=jg()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=EE(),this._integrationMaterial=AE());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/v0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-ME)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(y0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=TE());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Kg(n,t,e){return new yl(n,{minFilter:Bs,generateMipmaps:t,type:Ki,colorSpace:Na,depthBuffer:e})}function vl(n,t,e){return new Ni({name:n,uniforms:t,vertexShader:fe.cube_vert,fragmentShader:e,side:ni,blending:Or,depthTest:!1,depthWrite:!1})}function EE(){return vl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${y0}u

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
	`)}function AE(){return vl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:v0}},`

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
	`)}function TE(){return vl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${SE}
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
	`)}function jg(){return vl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Qg(){return vl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function CE(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===sh||f===rh)if(t.has(d)){let m=t.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let _=new yl(m.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===sh||f===rh,_=f===Br||f===Xo;if(m||_){let g=e.get(d),p=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return i===null&&(i=new Yh(n)),g=m?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let v=d.image;return m&&v&&v.height>0||_&&v&&l(v)?(i===null&&(i=new Yh(n)),g=m?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===sh?d.mapping=Br:f===rh&&(d.mapping=Xo),d}function l(d){let f=0,m=6;for(let _=0;_<m;_++)d[_]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function RE(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Ia("WebGLRenderer: "+i+" extension not supported."),s}}}function PE(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(m=>delete s[m]);function a(m){l(m.target)}function l(m){m.index!==null&&t.remove(m.index);for(let g in m.attributes)t.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete s[m.id],o.unregister(m);let _=r.get(m);_&&(t.remove(_),r.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function c(m,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(m){let _=m.attributes;for(let g in _)t.update(_[g],n.ARRAY_BUFFER)}function u(m){let _=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let v=_!==null?_.array.length:g.array.length/3-1,T=g.count>=65535?Va:ka,S=new T(Math.ceil(v/3)*6,1),C=S.array;if(_!==null){let x=_.array;p=_.version;for(let E=0,O=0;E<v;E+=3){let I=x[E+0],L=x[E+1],z=x[E+2];C[O++]=I,C[O++]=L,C[O++]=L,C[O++]=z,C[O++]=z,C[O++]=I}}else{p=g.version;for(let x=0,E=0;x<v;x+=3){let O=x+0,I=x+1,L=x+2;C[E++]=O,C[E++]=I,C[E++]=I,C[E++]=L,C[E++]=L,C[E++]=O}}S.version=p;let A=r.get(m);A&&t.remove(A),r.set(m,S)}function d(m){let _=r.get(m);if(_){let g=m.index;g!==null&&_.version<g.version&&u(m)}else u(m);return r.get(m)}function f(){for(let m in s){let _=s[m].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:d,dispose:f}}function IE(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function c(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let _=0;for(let g=0;g<f;g++)_+=d[g];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function LE(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:ee("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function DE(n,t,e){let i=new WeakMap,s=new Pe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let O=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;f===!0&&(T=1),m===!0&&(T=2),_===!0&&(T=3);let S=a.attributes.position.count*T,C=1;S>t.maxTextureSize&&(C=Math.ceil(S/t.maxTextureSize),S=t.maxTextureSize);let A=new Float32Array(S*C*4*u),x=new Ba(A,S,C,u);x.type=Ui,x.needsUpdate=!0;let E=T*4;for(let I=0;I<u;I++){let L=g[I],z=p[I],V=v[I],D=S*C*4*I;for(let H=0;H<L.count;H++){let $=H*E;f===!0&&(s.fromBufferAttribute(L,H),A[D+$+0]=s.x,A[D+$+1]=s.y,A[D+$+2]=s.z,A[D+$+3]=0),m===!0&&(s.fromBufferAttribute(z,H),A[D+$+4]=s.x,A[D+$+5]=s.y,A[D+$+6]=s.z,A[D+$+7]=0),_===!0&&(s.fromBufferAttribute(V,H),A[D+$+8]=s.x,A[D+$+9]=s.y,A[D+$+10]=s.z,A[D+$+11]=V.itemSize===4?s.w:1)}}d={count:u,texture:x,size:new Zt(S,C)},i.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function NE(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var UE={[Id]:"LINEAR_TONE_MAPPING",[Ld]:"REINHARD_TONE_MAPPING",[Dd]:"CINEON_TONE_MAPPING",[Nd]:"ACES_FILMIC_TONE_MAPPING",[Od]:"AGX_TONE_MAPPING",[Fd]:"NEUTRAL_TONE_MAPPING",[Ud]:"CUSTOM_TONE_MAPPING"};function OE(n,t,e,i,s,r){let o=new Mi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new Qe;h.setAttribute("position",new ye([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new ye([0,2,0,0,2,0],2));let u=new Vc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ge(h,u),f=new Nr(-1,1,1,-1,0,1),m=null,_=null,g=!1,p,v=null,T=[],S=!1;this.setSize=function(C,A){o.setSize(C,A),a!==null&&a.setSize(C,A),l!==null&&l.setSize(C,A);for(let x=0;x<T.length;x++){let E=T[x];E.setSize&&E.setSize(C,A)}},this.setEffects=function(C){T=C,S=T.length>0&&T[0].isRenderPass===!0;let A=o.width,x=o.height;T.length>0&&a===null&&(a=new Mi(A,x,{type:Ki,depthBuffer:!1,stencilBuffer:!1}),l=new Mi(A,x,{type:Ki,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&T.some(O=>O.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Fs(A,x),r===!0&&(c.format=zs,c.type=zr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let O=0;O<T.length;O++){let I=T[O];I.setSize&&I.setSize(A,x),E&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(c)}},this.begin=function(C,A){if(g||C.toneMapping===fs&&T.length===0)return!1;if(v=A,A!==null){let x=A.width,E=A.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return S===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=fs,!0},this.hasRenderPass=function(){return S},this.end=function(C,A){C.toneMapping=p,g=!0;let x=o,E=a;for(let O=0;O<T.length;O++){let I=T[O];I.enabled!==!1&&(I.render(C,E,x,A),I.needsSwap!==!1&&(x=E,E=E===a?l:a))}if(m!==C.outputColorSpace||_!==C.toneMapping){m=C.outputColorSpace,_=C.toneMapping,u.defines={},Se.getTransfer(m)===Re&&(u.defines.SRGB_TRANSFER="");let O=UE[_];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(v),C.render(d,f),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var S0=new ai,M0=new Fs(1,1),b0=new $a(1),w0=new Ba,E0=new Uc,A0=new Xa,t0=[],e0=[],n0=new Float32Array(16),i0=new Float32Array(9),s0=new Float32Array(4);function Zo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=t0[s];if(r===void 0&&(r=new Float32Array(s),t0[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Mn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function bn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Zh(n,t){let e=e0[t];e===void 0&&(e=new Int32Array(t),e0[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function FE(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function BE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;n.uniform2fv(this.addr,t),bn(e,t)}}function zE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Mn(e,t))return;n.uniform3fv(this.addr,t),bn(e,t)}}function kE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;n.uniform4fv(this.addr,t),bn(e,t)}}function VE(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,i))return;s0.set(i),n.uniformMatrix2fv(this.addr,!1,s0),bn(e,i)}}function GE(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,i))return;i0.set(i),n.uniformMatrix3fv(this.addr,!1,i0),bn(e,i)}}function HE(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Mn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(Mn(e,i))return;n0.set(i),n.uniformMatrix4fv(this.addr,!1,n0),bn(e,i)}}function WE(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function XE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;n.uniform2iv(this.addr,t),bn(e,t)}}function $E(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;n.uniform3iv(this.addr,t),bn(e,t)}}function YE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;n.uniform4iv(this.addr,t),bn(e,t)}}function qE(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function ZE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Mn(e,t))return;n.uniform2uiv(this.addr,t),bn(e,t)}}function JE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Mn(e,t))return;n.uniform3uiv(this.addr,t),bn(e,t)}}function KE(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Mn(e,t))return;n.uniform4uiv(this.addr,t),bn(e,t)}}function Jh(n){return n.version===0&&(n.compareFunction=Yd,n.needsUpdate=!0),n}function jE(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Jh(M0):r=S0,e.setTexture2D(t||r,s)}function QE(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||E0,s)}function t1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Jh(b0):r=A0,e.setTextureCube(t||r,s)}function e1(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||w0,s)}function n1(n){switch(n){case 5126:return FE;case 35664:return BE;case 35665:return zE;case 35666:return kE;case 35674:return VE;case 35675:return GE;case 35676:return HE;case 5124:case 35670:return WE;case 35667:case 35671:return XE;case 35668:case 35672:return $E;case 35669:case 35673:return YE;case 5125:return qE;case 36294:return ZE;case 36295:return JE;case 36296:return KE;case 35678:case 36198:case 36298:case 36306:case 35682:return jE;case 35679:case 36299:case 36307:return QE;case 35680:case 36300:case 36308:case 36293:return t1;case 36289:case 36303:case 36311:case 36292:return e1}}function i1(n,t){n.uniform1fv(this.addr,t)}function s1(n,t){let e=Zo(t,this.size,2);n.uniform2fv(this.addr,e)}function r1(n,t){let e=Zo(t,this.size,3);n.uniform3fv(this.addr,e)}function o1(n,t){let e=Zo(t,this.size,4);n.uniform4fv(this.addr,e)}function a1(n,t){let e=Zo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function l1(n,t){let e=Zo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function c1(n,t){let e=Zo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function h1(n,t){n.uniform1iv(this.addr,t)}function u1(n,t){n.uniform2iv(this.addr,t)}function d1(n,t){n.uniform3iv(this.addr,t)}function f1(n,t){n.uniform4iv(this.addr,t)}function p1(n,t){n.uniform1uiv(this.addr,t)}function m1(n,t){n.uniform2uiv(this.addr,t)}function g1(n,t){n.uniform3uiv(this.addr,t)}function _1(n,t){n.uniform4uiv(this.addr,t)}function x1(n,t,e){let i=this.cache,s=t.length,r=Zh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Jh(M0):o=S0;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function y1(n,t,e){let i=this.cache,s=t.length,r=Zh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||E0,r[o])}function v1(n,t,e){let i=this.cache,s=t.length,r=Zh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Jh(b0):o=A0;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function S1(n,t,e){let i=this.cache,s=t.length,r=Zh(e,s);Mn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||w0,r[o])}function M1(n){switch(n){case 5126:return i1;case 35664:return s1;case 35665:return r1;case 35666:return o1;case 35674:return a1;case 35675:return l1;case 35676:return c1;case 5124:case 35670:return h1;case 35667:case 35671:return u1;case 35668:case 35672:return d1;case 35669:case 35673:return f1;case 5125:return p1;case 36294:return m1;case 36295:return g1;case 36296:return _1;case 35678:case 36198:case 36298:case 36306:case 35682:return x1;case 35679:case 36299:case 36307:return y1;case 35680:case 36300:case 36308:case 36293:return v1;case 36289:case 36303:case 36311:case 36292:return S1}}var df=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=n1(e.type)}},ff=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=M1(e.type)}},pf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},hf=/(\w+)(\])?(\[|\.)?/g;function r0(n,t){n.seq.push(t),n.map[t.id]=t}function b1(n,t,e){let i=n.name,s=i.length;for(hf.lastIndex=0;;){let r=hf.exec(i),o=hf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){r0(e,c===void 0?new df(a,n,t):new ff(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new pf(a),r0(e,u)),e=u}}}var qo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);b1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function o0(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var w1=37297,E1=0;function A1(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var a0=new se;function T1(n){Se._getMatrix(a0,Se.workingColorSpace,n);let t=`mat3( ${a0.elements.map(e=>e.toFixed(4))} )`;switch(Se.getTransfer(n)){case Ua:return[t,"LinearTransferOETF"];case Re:return[t,"sRGBTransferOETF"];default:return Jt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function l0(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+A1(n.getShaderSource(t),a)}else return r}function C1(n,t){let e=T1(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var R1={[Id]:"Linear",[Ld]:"Reinhard",[Dd]:"Cineon",[Nd]:"ACESFilmic",[Od]:"AgX",[Fd]:"Neutral",[Ud]:"Custom"};function P1(n,t){let e=R1[t];return e===void 0?(Jt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var $h=new U;function I1(){Se.getLuminanceCoefficients($h);let n=$h.x.toFixed(4),t=$h.y.toFixed(4),e=$h.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function L1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(xl).join(`
`)}function D1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function N1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function xl(n){return n!==""}function c0(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function h0(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var U1=/^[ \t]*#include +<([\w\d./]+)>/gm;function mf(n){return n.replace(U1,O1)}function O1(n,t){let e=fe[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return mf(e)}var F1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function u0(n){return n.replace(F1,B1)}function B1(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function d0(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var z1={[Ur]:"SHADOWMAP_TYPE_PCF",[Ho]:"SHADOWMAP_TYPE_VSM"};function k1(n){return z1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var V1={[Xo]:"ENVMAP_MODE_REFRACTION"};function G1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":V1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var H1={[ih]:"ENVMAP_BLENDING_MULTIPLY",[Lg]:"ENVMAP_BLENDING_MIX",[Dg]:"ENVMAP_BLENDING_ADD"};function W1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":H1[n.combine]||"ENVMAP_BLENDING_NONE"}function X1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=k1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=G1(e),u=W1(e),d=L1(e),f=D1(r),m=s.createProgram(),_,g,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(xl).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(xl).join(`
`),g.length>0&&(g+=`
`)):(_=[d0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(xl).join(`
`),g=[d0(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==fs?"#define TONE_MAPPING":"",e.toneMapping!==fs?fe.tonemapping_pars_fragment:"",e.toneMapping!==fs?P1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",fe.colorspace_pars_fragment,C1("linearToOutputTexel",e.outputColorSpace),I1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(xl).join(`
`)),o=mf(o),o=c0(o,e),o=h0(o,e),a=mf(a),a=c0(a,e),a=h0(a,e),o=u0(o),a=u0(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",e.glslVersion===Zd?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Zd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=p+_+o,T=p+g+a,S=o0(s,s.VERTEX_SHADER,v),C=o0(s,s.FRAGMENT_SHADER,T);s.attachShader(m,S),s.attachShader(m,C),e.index0AttributeName!==void 0?s.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(m,0,"position"),s.linkProgram(m);function A(I){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(m)||"",z=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(C)||"",D=L.trim(),H=z.trim(),$=V.trim(),G=!0,lt=!0;if(s.getProgramParameter(m,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,m,S,C);else{let Z=l0(s,S,"vertex"),j=l0(s,C,"fragment");ee("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(m,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+D+`
`+Z+`
`+j)}else D!==""?Jt("WebGLProgram: Program Info Log:",D):(H===""||$==="")&&(lt=!1);lt&&(I.diagnostics={runnable:G,programLog:D,vertexShader:{log:H,prefix:_},fragmentShader:{log:$,prefix:g}})}s.deleteShader(S),s.deleteShader(C),x=new qo(s,m),E=N1(s,m)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let E;this.getAttributes=function(){return E===void 0&&A(this),E};let O=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(m,w1)),O},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=E1++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=C,this}var $1=0,gf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new _f(t),e.set(t,i)),i}},_f=class{constructor(t){this.id=$1++,this.code=t,this.usedTimes=0}};function Y1(n){return n===pr||n===fl||n===pl}function q1(n,t,e,i,s,r){let o=new Oo,a=new gf,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,E,O,I,L,z){let V=I.fog,D=L.geometry,H=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=t.get(x.envMap||H,$),lt=d[x.type],Z=i.precision;x.precision!==null&&(Z=i.getMaxPrecision(x.precision),Z!==x.precision&&Jt("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let j=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,et=j!==void 0?j.length:0,ft=0;D.morphAttributes.position!==void 0&&(ft=1),D.morphAttributes.normal!==void 0&&(ft=2),D.morphAttributes.color!==void 0&&(ft=3);let dt,tt,gt,yt;if(lt){let Rt=ii[lt];dt=Rt.vertexShader,tt=Rt.fragmentShader}else{dt=x.vertexShader,tt=x.fragmentShader;let Rt=a.getVertexShaderStage(x),he=a.getFragmentShaderStage(x);a.update(x,Rt,he),gt=Rt.id,yt=he.id}let Ct=n.getRenderTarget(),bt=n.state.buffers.depth.getReversed(),$t=L.isInstancedMesh===!0,ae=L.isBatchedMesh===!0,Ht=!!x.map,pe=!!x.matcap,ue=!!G,re=ue&&G.isPMREMTexture===!0,Je=!!x.aoMap,Ve=!!x.lightMap,ln=!!x.bumpMap&&x.wireframe===!1,Ue=!!x.normalMap,Rn=!!x.displacementMap,be=!!x.emissiveMap,yn=!!x.metalnessMap,tn=!!x.roughnessMap,cn=x.anisotropy>0,B=x.clearcoat>0,Pt=x.diffuseRoughness>0,Kt=x.dispersion>0,le=x.retroreflectivity>0,wt=x.iridescence>0,Be=x.sheen>0,Gt=x.transmission>0,qt=cn&&!!x.anisotropyMap,R=B&&!!x.clearcoatMap,M=B&&!!x.clearcoatNormalMap,X=B&&!!x.clearcoatRoughnessMap,ut=Pt&&!!x.diffuseRoughnessMap,ot=wt&&!!x.iridescenceMap,xt=wt&&!!x.iridescenceThicknessMap,vt=Be&&!!x.sheenColorMap,nt=Be&&!!x.sheenRoughnessMap,st=!!x.specularMap,mt=!!x.specularColorMap,F=!!x.specularIntensityMap,rt=Gt&&!!x.transmissionMap,it=Gt&&!!x.thicknessMap,Et=!!x.gradientMap,_t=!!x.alphaMap,Mt=x.alphaTest>0,Wt=!!x.alphaHash,Qt=!!x.extensions,ht=fs;x.toneMapped&&(Ct===null||Ct.isXRRenderTarget===!0)&&(ht=n.toneMapping);let zt=re?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,te={shaderID:lt,shaderType:x.type,shaderName:x.name,vertexShader:dt,fragmentShader:tt,defines:x.defines,customVertexShaderID:gt,customFragmentShaderID:yt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:ae,batchingColor:ae&&L._colorsTexture!==null,instancing:$t,instancingColor:$t&&L.instanceColor!==null,instancingMorph:$t&&L.morphTexture!==null,outputColorSpace:Ct===null?n.outputColorSpace:Ct.isXRRenderTarget===!0?Ct.texture.colorSpace:Se.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ht,matcap:pe,envMap:ue,envMapMode:ue&&G.mapping,envMapPMREM:re,envMapMaxLod:re?zt.length-1:null,envMapSize:re?zt[0].width:null,aoMap:Je,lightMap:Ve,bumpMap:ln,normalMap:Ue,displacementMap:Rn,emissiveMap:be,normalMapObjectSpace:Ue&&x.normalMapType===Og,normalMapTangentSpace:Ue&&x.normalMapType===ml,packedNormalMap:Ue&&x.normalMapType===ml&&Y1(x.normalMap.format),metalnessMap:yn,roughnessMap:tn,anisotropy:cn,anisotropyMap:qt,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:X,diffuseRoughness:Pt,diffuseRoughnessMap:ut,dispersion:Kt,retroreflection:le,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:xt,sheen:Be,sheenColorMap:vt,sheenRoughnessMap:nt,specularMap:st,specularColorMap:mt,specularIntensityMap:F,transmission:Gt,transmissionMap:rt,thicknessMap:it,gradientMap:Et,opaque:x.transparent===!1&&x.blending===Wo&&x.alphaToCoverage===!1,alphaMap:_t,alphaTest:Mt,alphaHash:Wt,combine:x.combine,mapUv:Ht&&f(x.map.channel),aoMapUv:Je&&f(x.aoMap.channel),lightMapUv:Ve&&f(x.lightMap.channel),bumpMapUv:ln&&f(x.bumpMap.channel),normalMapUv:Ue&&f(x.normalMap.channel),displacementMapUv:Rn&&f(x.displacementMap.channel),emissiveMapUv:be&&f(x.emissiveMap.channel),metalnessMapUv:yn&&f(x.metalnessMap.channel),roughnessMapUv:tn&&f(x.roughnessMap.channel),anisotropyMapUv:qt&&f(x.anisotropyMap.channel),clearcoatMapUv:R&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:vt&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:nt&&f(x.sheenRoughnessMap.channel),specularMapUv:st&&f(x.specularMap.channel),specularColorMapUv:mt&&f(x.specularColorMap.channel),specularIntensityMapUv:F&&f(x.specularIntensityMap.channel),transmissionMapUv:rt&&f(x.transmissionMap.channel),thicknessMapUv:it&&f(x.thicknessMap.channel),alphaMapUv:_t&&f(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ue||cn),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(Ht||_t),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&Ue===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:bt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:ft,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:z.filter(Rt=>Rt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&O.length>0,shadowMapType:n.shadowMap.type,toneMapping:ht,decodeVideoTexture:Ht&&x.map.isVideoTexture===!0&&Se.getTransfer(x.map.colorSpace)===Re,decodeVideoTextureEmissive:be&&x.emissiveMap.isVideoTexture===!0&&Se.getTransfer(x.emissiveMap.colorSpace)===Re,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Fn,flipSided:x.side===ni,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Qt&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Qt&&x.extensions.multiDraw===!0||ae)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return te.vertexUv1s=l.has(1),te.vertexUv2s=l.has(2),te.vertexUv3s=l.has(3),l.clear(),te}function _(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)E.push(O),E.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(g(E,x),p(E,x),E.push(n.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function g(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function p(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let E=d[x.type],O;if(E){let I=ii[E];O=gl.clone(I.uniforms)}else O=x.uniforms;return O}function T(x,E){let O=h.get(E);return O!==void 0?++O.usedTimes:(O=new X1(n,E,x,s),c.push(O),h.set(E,O)),O}function S(x){if(--x.usedTimes===0){let E=c.indexOf(x);c[E]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function A(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:v,acquireProgram:T,releaseProgram:S,releaseShaderCache:C,programs:c,dispose:A}}function Z1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function J1(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function f0(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function p0(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,_,g,p){let v=n[t];return v===void 0?(v={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:g,group:p},n[t]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=m,v.materialVariant=o(d),v.groupOrder=_,v.renderOrder=d.renderOrder,v.z=g,v.group=p),t++,v}function l(d,f,m,_,g,p,v){v.reversedDepth===!0&&(g=-g);let T=a(d,f,m,_,g,p);m.transmission>0?i.push(T):m.transparent===!0?s.push(T):e.push(T)}function c(d,f,m,_,g,p){let v=a(d,f,m,_,g,p);m.transmission>0?i.unshift(v):m.transparent===!0?s.unshift(v):e.unshift(v)}function h(d,f){e.length>1&&e.sort(d||J1),i.length>1&&i.sort(f||f0),s.length>1&&s.sort(f||f0)}function u(){for(let d=t,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function K1(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new p0,n.set(i,[o])):s>=r.length?(o=new p0,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function j1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new U,color:new ne};break;case"SpotLight":e={position:new U,direction:new U,color:new ne,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new U,color:new ne,distance:0,decay:0};break;case"HemisphereLight":e={direction:new U,skyColor:new ne,groundColor:new ne};break;case"RectAreaLight":e={color:new ne,position:new U,halfWidth:new U,halfHeight:new U};break}return n[t.id]=e,e}}}function Q1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var tA=0;function eA(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function nA(n){let t=new j1,e=Q1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new U);let s=new U,r=new xe,o=new xe;function a(c){let h=0,u=0,d=0;for(let z=0;z<9;z++)i.probe[z].set(0,0,0);let f=0,m=0,_=0,g=0,p=0,v=0,T=0,S=0,C=0,A=0,x=0,E=0,O=0,I=0;c.sort(eA);for(let z=0,V=c.length;z<V;z++){let D=c[z],H=D.color,$=D.intensity,G=D.distance,lt=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===pr?lt=D.shadow.map.texture:lt=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)h+=H.r*$,u+=H.g*$,d+=H.b*$;else if(D.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(D.sh.coefficients[Z],$);I++}else if(D.isSunLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,et=e.get(D);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[m]=et,i.sunShadowMap[m]=lt;let ft=j.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[_+dt]=j.getMatrix(dt),i.sunShadowCascade[_+dt]=j._cascadeData[dt];_+=ft,m++}i.sun[f]=Z,f++}else if(D.isDirectionalLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let j=D.shadow,et=e.get(D);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.directionalShadow[g]=et,i.directionalShadowMap[g]=lt,i.directionalShadowMatrix[g]=D.shadow.matrix,C++}i.directional[g]=Z,g++}else if(D.isSpotLight){let Z=t.get(D);Z.position.setFromMatrixPosition(D.matrixWorld),Z.color.copy(H).multiplyScalar($),Z.distance=G,Z.coneCos=Math.cos(D.angle),Z.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Z.decay=D.decay,i.spot[v]=Z;let j=D.shadow;if(D.map&&(i.spotLightMap[E]=D.map,E++,j.updateMatrices(D),D.castShadow&&O++),i.spotLightMatrix[v]=j.matrix,D.castShadow){let et=e.get(D);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,i.spotShadow[v]=et,i.spotShadowMap[v]=lt,x++}v++}else if(D.isRectAreaLight){let Z=t.get(D);Z.color.copy(H).multiplyScalar($),Z.halfWidth.set(D.width*.5,0,0),Z.halfHeight.set(0,D.height*.5,0),i.rectArea[T]=Z,T++}else if(D.isPointLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),Z.distance=D.distance,Z.decay=D.decay,D.castShadow){let j=D.shadow,et=e.get(D);et.shadowIntensity=j.intensity,et.shadowBias=j.bias,et.shadowNormalBias=j.normalBias,et.shadowRadius=j.radius,et.shadowMapSize=j.mapSize,et.shadowCameraNear=j.camera.near,et.shadowCameraFar=j.camera.far,i.pointShadow[p]=et,i.pointShadowMap[p]=lt,i.pointShadowMatrix[p]=D.shadow.matrix,A++}i.point[p]=Z,p++}else if(D.isHemisphereLight){let Z=t.get(D);Z.skyColor.copy(D.color).multiplyScalar($),Z.groundColor.copy(D.groundColor).multiplyScalar($),i.hemi[S]=Z,S++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=It.LTC_FLOAT_1,i.rectAreaLTC2=It.LTC_FLOAT_2):(i.rectAreaLTC1=It.LTC_HALF_1,i.rectAreaLTC2=It.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let L=i.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==p||L.spotLength!==v||L.rectAreaLength!==T||L.hemiLength!==S||L.numSunShadows!==m||L.numDirectionalShadows!==C||L.numPointShadows!==A||L.numSpotShadows!==x||L.numSpotMaps!==E||L.numLightProbes!==I)&&(i.sun.length=f,i.directional.length=g,i.spot.length=v,i.rectArea.length=T,i.point.length=p,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=A,i.pointShadowMap.length=A,i.pointShadowMatrix.length=A,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+E-O,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=O,i.numLightProbes=I,L.sunLength=f,L.directionalLength=g,L.pointLength=p,L.spotLength=v,L.rectAreaLength=T,L.hemiLength=S,L.numSunShadows=m,L.numDirectionalShadows=C,L.numPointShadows=A,L.numSpotShadows=x,L.numSpotMaps=E,L.numLightProbes=I,i.version=tA++)}function l(c,h){let u=0,d=0,f=0,m=0,_=0,g=0,p=h.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let S=c[v];if(S.isSunLight){let C=i.sun[u];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),u++}else if(S.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(S.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),m++}else if(S.isRectAreaLight){let C=i.rectArea[_];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(S.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(S.width*.5,0,0),C.halfHeight.set(0,S.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(S.matrixWorld),C.position.applyMatrix4(p),f++}else if(S.isHemisphereLight){let C=i.hemi[g];C.direction.setFromMatrixPosition(S.matrixWorld),C.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:i}}function m0(n){let t=new nA(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function iA(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new m0(n),t.set(s,[a])):r>=o.length?(a=new m0(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var sA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,rA=`uniform sampler2D shadow_pass;
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
}`,oA=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],aA=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],g0=new xe,_l=new U,uf=new U;function lA(n,t,e){let i=new ir,s=new Zt,r=new Zt,o=new Pe,a=new Gc,l=new Hc,c={},h=e.maxTextureSize,u={[fr]:ni,[ni]:fr,[Fn]:Fn},d=new Ni({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:sA,fragmentShader:rA}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Qe;m.setAttribute("position",new Un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ge(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ur;let p=this.type;this.render=function(A,x,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||A.length===0)return;this.type===fg&&(Jt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ur);let O=n.getRenderTarget(),I=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),z=n.state;z.setBlending(Or),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let V=p!==this.type;V&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(H=>H.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,H=A.length;D<H;D++){let $=A[D],G=$.shadow;if(G===void 0){Jt("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let lt=G.getFrameExtents();s.multiply(lt),r.copy(G.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,G.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,G.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Z,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Ho){if($.isPointLight){Jt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Mi(s.x,s.y,{format:pr,type:Ki,minFilter:ei,magFilter:ei,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new Fs(s.x,s.y,Ui),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=Os,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On}else $.isPointLight?(G.map=new yl(s.x),G.map.depthTexture=new $a(s.x,Ji)):(G.map=new Mi(s.x,s.y),G.map.depthTexture=new Fs(s.x,s.y,Ji)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=Os,this.type===Ur?(G.map.depthTexture.compareFunction=Z?$d:Xd,G.map.depthTexture.minFilter=ei,G.map.depthTexture.magFilter=ei):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,E);let et=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let ft=0;ft<j;ft++){let dt=G.getCamera(ft);if($.isPointLight){let tt=G.camera,gt=G.matrix,yt=$.distance||tt.far;yt!==tt.far&&(tt.far=yt,tt.updateProjectionMatrix()),_l.setFromMatrixPosition($.matrixWorld),tt.position.copy(_l),uf.copy(tt.position),uf.add(oA[ft]),tt.up.copy(aA[ft]),tt.lookAt(uf),tt.updateMatrixWorld(),gt.makeTranslation(-_l.x,-_l.y,-_l.z),g0.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),G._frustum.setFromProjectionMatrix(g0,tt.coordinateSystem,tt.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(G.map),n.clear());let tt=G.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),z.viewport(o)}i=G.getFrustum(ft),S(x,E,dt,$,et,this.type)}G.isPointLightShadow!==!0&&this.type===Ho&&v(G,E),G.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(O,I,L)};function v(A,x){let E=t.update(_);d.defines.VSM_SAMPLES!==A.blurSamples&&(d.defines.VSM_SAMPLES=A.blurSamples,f.defines.VSM_SAMPLES=A.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),A.mapPass===null?A.mapPass=new Mi(s.x,s.y,{format:pr,type:Ki}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),d.uniforms.shadow_pass.value=A.map.depthTexture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,n.setRenderTarget(A.mapPass),n.clear(),n.renderBufferDirect(x,null,E,d,_,null),f.uniforms.shadow_pass.value=A.mapPass.texture,f.uniforms.resolution.value.set(A.map.width,A.map.height),f.uniforms.radius.value=A.radius,n.setRenderTarget(A.map),n.clear(),n.renderBufferDirect(x,null,E,f,_,null)}function T(A,x,E,O){let I=null,L=E.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)I=L;else if(I=E.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=I.uuid,V=x.uuid,D=c[z];D===void 0&&(D={},c[z]=D);let H=D[V];H===void 0&&(H=I.clone(),D[V]=H,x.addEventListener("dispose",C)),I=H}if(I.visible=x.visible,I.wireframe=x.wireframe,O===Ho?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:u[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,E.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let z=n.properties.get(I);z.light=E}return I}function S(A,x,E,O,I,L){if(A.visible===!1)return;if(A.layers.test(I)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===Ho)&&(!A.frustumCulled||A.intersectsFrustum(i))){A.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,A.matrixWorld);let D=t.update(A),H=A.material;if(Array.isArray(H)){let $=D.groups;for(let G=0,lt=$.length;G<lt;G++){let Z=$[G],j=H[Z.materialIndex];if(j&&j.visible){let et=T(A,j,O,L);A.onBeforeShadow(n,A,x,E,D,et,Z),n.renderBufferDirect(E,null,D,et,A,Z),A.onAfterShadow(n,A,x,E,D,et,Z)}}}else if(H.visible){let $=T(A,H,O,L);A.onBeforeShadow(n,A,x,E,D,$,null),n.renderBufferDirect(E,null,D,$,A,null),A.onAfterShadow(n,A,x,E,D,$,null)}}let V=A.children;for(let D=0,H=V.length;D<H;D++)S(V[D],x,E,O,I,L)}function C(A){A.target.removeEventListener("dispose",C);for(let E in c){let O=c[E],I=A.target.uuid;I in O&&(O[I].dispose(),delete O[I])}}}function cA(n,t){function e(){let F=!1,rt=new Pe,it=null,Et=new Pe(0,0,0,0);return{setMask:function(_t){it!==_t&&!F&&(n.colorMask(_t,_t,_t,_t),it=_t)},setLocked:function(_t){F=_t},setClear:function(_t,Mt,Wt,Qt,ht){ht===!0&&(_t*=Qt,Mt*=Qt,Wt*=Qt),rt.set(_t,Mt,Wt,Qt),Et.equals(rt)===!1&&(n.clearColor(_t,Mt,Wt,Qt),Et.copy(rt))},reset:function(){F=!1,it=null,Et.set(-1,0,0,0)}}}function i(){let F=!1,rt=!1,it=null,Et=null,_t=null;return{setReversed:function(Mt){if(rt!==Mt){let Wt=t.get("EXT_clip_control");Mt?Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.ZERO_TO_ONE_EXT):Wt.clipControlEXT(Wt.LOWER_LEFT_EXT,Wt.NEGATIVE_ONE_TO_ONE_EXT),rt=Mt;let Qt=_t;_t=null,this.setClear(Qt)}},getReversed:function(){return rt},setTest:function(Mt){Mt?bt(n.DEPTH_TEST):$t(n.DEPTH_TEST)},setMask:function(Mt){it!==Mt&&!F&&(n.depthMask(Mt),it=Mt)},setFunc:function(Mt){if(rt&&(Mt=$g[Mt]),Et!==Mt){switch(Mt){case bc:n.depthFunc(n.NEVER);break;case wc:n.depthFunc(n.ALWAYS);break;case Ec:n.depthFunc(n.LESS);break;case Io:n.depthFunc(n.LEQUAL);break;case Ac:n.depthFunc(n.EQUAL);break;case Tc:n.depthFunc(n.GEQUAL);break;case Cc:n.depthFunc(n.GREATER);break;case Rc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Et=Mt}},setLocked:function(Mt){F=Mt},setClear:function(Mt){_t!==Mt&&(_t=Mt,rt&&(Mt=1-Mt),n.clearDepth(Mt))},reset:function(){F=!1,it=null,Et=null,_t=null,rt=!1}}}function s(){let F=!1,rt=null,it=null,Et=null,_t=null,Mt=null,Wt=null,Qt=null,ht=null;return{setTest:function(zt){F||(zt?bt(n.STENCIL_TEST):$t(n.STENCIL_TEST))},setMask:function(zt){rt!==zt&&!F&&(n.stencilMask(zt),rt=zt)},setFunc:function(zt,te,Rt){(it!==zt||Et!==te||_t!==Rt)&&(n.stencilFunc(zt,te,Rt),it=zt,Et=te,_t=Rt)},setOp:function(zt,te,Rt){(Mt!==zt||Wt!==te||Qt!==Rt)&&(n.stencilOp(zt,te,Rt),Mt=zt,Wt=te,Qt=Rt)},setLocked:function(zt){F=zt},setClear:function(zt){ht!==zt&&(n.clearStencil(zt),ht=zt)},reset:function(){F=!1,rt=null,it=null,Et=null,_t=null,Mt=null,Wt=null,Qt=null,ht=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},f=new WeakMap,m=[],_=null,g=!1,p=null,v=null,T=null,S=null,C=null,A=null,x=null,E=new ne(0,0,0),O=0,I=!1,L=null,z=null,V=null,D=null,H=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,lt=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(Z)[1]),G=lt>=1):Z.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),G=lt>=2);let j=null,et={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),tt=new Pe().fromArray(ft),gt=new Pe().fromArray(dt);function yt(F,rt,it,Et){let _t=new Uint8Array(4),Mt=n.createTexture();n.bindTexture(F,Mt),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Wt=0;Wt<it;Wt++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,Et,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(rt+Wt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return Mt}let Ct={};Ct[n.TEXTURE_2D]=yt(n.TEXTURE_2D,n.TEXTURE_2D,1),Ct[n.TEXTURE_CUBE_MAP]=yt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ct[n.TEXTURE_2D_ARRAY]=yt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ct[n.TEXTURE_3D]=yt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),bt(n.DEPTH_TEST),o.setFunc(Io),ln(!1),Ue(Ed),bt(n.CULL_FACE),Je(Or);function bt(F){h[F]!==!0&&(n.enable(F),h[F]=!0)}function $t(F){h[F]!==!1&&(n.disable(F),h[F]=!1)}function ae(F,rt){return d[F]!==rt?(n.bindFramebuffer(F,rt),d[F]=rt,F===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),F===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Ht(F,rt){let it=m,Et=!1;if(F){it=f.get(rt),it===void 0&&(it=[],f.set(rt,it));let _t=F.textures;if(it.length!==_t.length||it[0]!==n.COLOR_ATTACHMENT0){for(let Mt=0,Wt=_t.length;Mt<Wt;Mt++)it[Mt]=n.COLOR_ATTACHMENT0+Mt;it.length=_t.length,Et=!0}}else it[0]!==n.BACK&&(it[0]=n.BACK,Et=!0);Et&&n.drawBuffers(it)}function pe(F){return _!==F?(n.useProgram(F),_=F,!0):!1}let ue={[Fr]:n.FUNC_ADD,[mg]:n.FUNC_SUBTRACT,[gg]:n.FUNC_REVERSE_SUBTRACT};ue[_g]=n.MIN,ue[xg]=n.MAX;let re={[yg]:n.ZERO,[vg]:n.ONE,[Sg]:n.SRC_COLOR,[Rd]:n.SRC_ALPHA,[Tg]:n.SRC_ALPHA_SATURATE,[Eg]:n.DST_COLOR,[bg]:n.DST_ALPHA,[Mg]:n.ONE_MINUS_SRC_COLOR,[Pd]:n.ONE_MINUS_SRC_ALPHA,[Ag]:n.ONE_MINUS_DST_COLOR,[wg]:n.ONE_MINUS_DST_ALPHA,[Cg]:n.CONSTANT_COLOR,[Rg]:n.ONE_MINUS_CONSTANT_COLOR,[Pg]:n.CONSTANT_ALPHA,[Ig]:n.ONE_MINUS_CONSTANT_ALPHA};function Je(F,rt,it,Et,_t,Mt,Wt,Qt,ht,zt){if(F===Or){g===!0&&($t(n.BLEND),g=!1);return}if(g===!1&&(bt(n.BLEND),g=!0),F!==pg){if(F!==p||zt!==I){if((v!==Fr||C!==Fr)&&(n.blendEquation(n.FUNC_ADD),v=Fr,C=Fr),zt)switch(F){case Wo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFunc(n.ONE,n.ONE);break;case Td:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Cd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:ee("WebGLState: Invalid blending: ",F);break}else switch(F){case Wo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Td:ee("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cd:ee("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:ee("WebGLState: Invalid blending: ",F);break}T=null,S=null,A=null,x=null,E.set(0,0,0),O=0,p=F,I=zt}return}_t=_t||rt,Mt=Mt||it,Wt=Wt||Et,(rt!==v||_t!==C)&&(n.blendEquationSeparate(ue[rt],ue[_t]),v=rt,C=_t),(it!==T||Et!==S||Mt!==A||Wt!==x)&&(n.blendFuncSeparate(re[it],re[Et],re[Mt],re[Wt]),T=it,S=Et,A=Mt,x=Wt),(Qt.equals(E)===!1||ht!==O)&&(n.blendColor(Qt.r,Qt.g,Qt.b,ht),E.copy(Qt),O=ht),p=F,I=!1}function Ve(F,rt){F.side===Fn?$t(n.CULL_FACE):bt(n.CULL_FACE);let it=F.side===ni;rt&&(it=!it),ln(it),F.blending===Wo&&F.transparent===!1?Je(Or):Je(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Et=F.stencilWrite;a.setTest(Et),Et&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),be(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?bt(n.SAMPLE_ALPHA_TO_COVERAGE):$t(n.SAMPLE_ALPHA_TO_COVERAGE)}function ln(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Ue(F){F!==ug?(bt(n.CULL_FACE),F!==z&&(F===Ed?n.cullFace(n.BACK):F===dg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$t(n.CULL_FACE),z=F}function Rn(F){F!==V&&(G&&n.lineWidth(F),V=F)}function be(F,rt,it){F?(bt(n.POLYGON_OFFSET_FILL),(D!==rt||H!==it)&&(D=rt,H=it,o.getReversed()&&(rt=-rt,it=-it),n.polygonOffset(rt,it))):$t(n.POLYGON_OFFSET_FILL)}function yn(F){F?bt(n.SCISSOR_TEST):$t(n.SCISSOR_TEST)}function tn(F){F===void 0&&(F=n.TEXTURE0+$-1),j!==F&&(n.activeTexture(F),j=F)}function cn(F,rt,it){it===void 0&&(j===null?it=n.TEXTURE0+$-1:it=j);let Et=et[it];Et===void 0&&(Et={type:void 0,texture:void 0},et[it]=Et),(Et.type!==F||Et.texture!==rt)&&(j!==it&&(n.activeTexture(it),j=it),n.bindTexture(F,rt||Ct[F]),Et.type=F,Et.texture=rt)}function B(){let F=et[j];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Pt(){try{n.compressedTexImage2D(...arguments)}catch(F){ee("WebGLState:",F)}}function Kt(){try{n.compressedTexImage3D(...arguments)}catch(F){ee("WebGLState:",F)}}function le(){try{n.texSubImage2D(...arguments)}catch(F){ee("WebGLState:",F)}}function wt(){try{n.texSubImage3D(...arguments)}catch(F){ee("WebGLState:",F)}}function Be(){try{n.compressedTexSubImage2D(...arguments)}catch(F){ee("WebGLState:",F)}}function Gt(){try{n.compressedTexSubImage3D(...arguments)}catch(F){ee("WebGLState:",F)}}function qt(){try{n.texStorage2D(...arguments)}catch(F){ee("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){ee("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){ee("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){ee("WebGLState:",F)}}function ut(F){return u[F]!==void 0?u[F]:n.getParameter(F)}function ot(F,rt){u[F]!==rt&&(n.pixelStorei(F,rt),u[F]=rt)}function xt(F){tt.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),tt.copy(F))}function vt(F){gt.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),gt.copy(F))}function nt(F,rt){let it=c.get(rt);it===void 0&&(it=new WeakMap,c.set(rt,it));let Et=it.get(F);Et===void 0&&(Et=n.getUniformBlockIndex(rt,F.name),n.uniformBlockBinding(rt,Et,Et),it.set(F,Et))}function st(F,rt,it){let _t=c.get(rt).get(F);l[_t]!==it&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,it),l[_t]=it)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},j=null,et={},d={},l={},f=new WeakMap,m=[],_=null,g=!1,p=null,v=null,T=null,S=null,C=null,A=null,x=null,E=new ne(0,0,0),O=0,I=!1,L=null,z=null,V=null,D=null,H=null,tt.set(0,0,n.canvas.width,n.canvas.height),gt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:bt,disable:$t,bindFramebuffer:ae,drawBuffers:Ht,useProgram:pe,setBlending:Je,setMaterial:Ve,setFlipSided:ln,setCullFace:Ue,setLineWidth:Rn,setPolygonOffset:be,setScissorTest:yn,activeTexture:tn,bindTexture:cn,unbindTexture:B,compressedTexImage2D:Pt,compressedTexImage3D:Kt,texImage2D:M,texImage3D:X,pixelStorei:ot,getParameter:ut,updateUBOMapping:nt,uniformBlockBinding:st,texStorage2D:qt,texStorage3D:R,texSubImage2D:le,texSubImage3D:wt,compressedTexSubImage2D:Be,compressedTexSubImage3D:Gt,scissor:xt,viewport:vt,reset:mt}}function hA(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,h=new WeakMap,u=new Set,d,f=new WeakMap,m=new Set,_=new FinalizationRegistry(R=>m.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,M){return g?new OffscreenCanvas(R,M):Oa("canvas")}function v(R,M,X){let ut=1,ot=qt(R);if((ot.width>X||ot.height>X)&&(ut=X/Math.max(ot.width,ot.height)),ut<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xt=Math.floor(ut*ot.width),vt=Math.floor(ut*ot.height);d===void 0&&(d=p(xt,vt));let nt=M?p(xt,vt):d;return nt.width=xt,nt.height=vt,nt.getContext("2d").drawImage(R,0,0,xt,vt),Jt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+xt+"x"+vt+")."),nt}else return"data"in R&&Jt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),R;return R}function T(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function A(R,M,X,ut,ot,xt=!1){if(R!==null){if(n[R]!==void 0)return n[R];Jt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let vt;ut&&(vt=t.get("EXT_texture_norm16"),vt||Jt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let nt=M;if(M===n.RED&&(X===n.FLOAT&&(nt=n.R32F),X===n.HALF_FLOAT&&(nt=n.R16F),X===n.UNSIGNED_BYTE&&(nt=n.R8),X===n.UNSIGNED_SHORT&&vt&&(nt=vt.R16_EXT),X===n.SHORT&&vt&&(nt=vt.R16_SNORM_EXT)),M===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.R8UI),X===n.UNSIGNED_SHORT&&(nt=n.R16UI),X===n.UNSIGNED_INT&&(nt=n.R32UI),X===n.BYTE&&(nt=n.R8I),X===n.SHORT&&(nt=n.R16I),X===n.INT&&(nt=n.R32I)),M===n.RG&&(X===n.FLOAT&&(nt=n.RG32F),X===n.HALF_FLOAT&&(nt=n.RG16F),X===n.UNSIGNED_BYTE&&(nt=n.RG8),X===n.UNSIGNED_SHORT&&vt&&(nt=vt.RG16_EXT),X===n.SHORT&&vt&&(nt=vt.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RG8UI),X===n.UNSIGNED_SHORT&&(nt=n.RG16UI),X===n.UNSIGNED_INT&&(nt=n.RG32UI),X===n.BYTE&&(nt=n.RG8I),X===n.SHORT&&(nt=n.RG16I),X===n.INT&&(nt=n.RG32I)),M===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RGB8UI),X===n.UNSIGNED_SHORT&&(nt=n.RGB16UI),X===n.UNSIGNED_INT&&(nt=n.RGB32UI),X===n.BYTE&&(nt=n.RGB8I),X===n.SHORT&&(nt=n.RGB16I),X===n.INT&&(nt=n.RGB32I)),M===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(nt=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(nt=n.RGBA16UI),X===n.UNSIGNED_INT&&(nt=n.RGBA32UI),X===n.BYTE&&(nt=n.RGBA8I),X===n.SHORT&&(nt=n.RGBA16I),X===n.INT&&(nt=n.RGBA32I)),M===n.RGB&&(X===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGB16_EXT),X===n.SHORT&&vt&&(nt=vt.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(nt=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(nt=n.R11F_G11F_B10F)),M===n.RGBA){let st=xt?Ua:Se.getTransfer(ot);X===n.FLOAT&&(nt=n.RGBA32F),X===n.HALF_FLOAT&&(nt=n.RGBA16F),X===n.UNSIGNED_BYTE&&(nt=st===Re?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&vt&&(nt=vt.RGBA16_EXT),X===n.SHORT&&vt&&(nt=vt.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(nt=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(nt=n.RGB5_A1)}return(nt===n.R16F||nt===n.R32F||nt===n.RG16F||nt===n.RG32F||nt===n.RGBA16F||nt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),nt}function x(R,M){let X;return R?M===null||M===Ji||M===zr?X=n.DEPTH24_STENCIL8:M===Ui?X=n.DEPTH32F_STENCIL8:M===$o&&(X=n.DEPTH24_STENCIL8,Jt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ji||M===zr?X=n.DEPTH_COMPONENT24:M===Ui?X=n.DEPTH_COMPONENT32F:M===$o&&(X=n.DEPTH_COMPONENT16),X}function E(R,M){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==ei?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function O(R){let M=new WeakRef(R);i.get(R).__ref=M,m.add(M),_.register(R,M,M)}function I(R){let M=i.get(R).__ref;M!==void 0&&(m.delete(M),_.unregister(M))}function L(R){V(R.target)}function z(R){D(R.target)}function V(R){R.removeEventListener("dispose",L),I(R),$(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function D(R){R.removeEventListener("dispose",z),I(R),lt(R)}function H(){for(let R of m){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?D(M):V(M))}m.clear(),u.clear()}function $(R){let M=i.get(R);if(M.__webglInit===void 0)return;let X=R.source,ut=f.get(X);if(ut){let ot=ut[M.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&G(R),Object.keys(ut).length===0&&f.delete(X)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let X=R.source,ut=f.get(X);delete ut[M.__cacheKey],o.memory.textures--}function lt(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&V(X),R.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(M.__webglFramebuffer[ot]))for(let xt=0;xt<M.__webglFramebuffer[ot].length;xt++)n.deleteFramebuffer(M.__webglFramebuffer[ot][xt]);else n.deleteFramebuffer(M.__webglFramebuffer[ot]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ot])}else{if(Array.isArray(M.__webglFramebuffer))for(let ot=0;ot<M.__webglFramebuffer.length;ot++)n.deleteFramebuffer(M.__webglFramebuffer[ot]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ot=0;ot<M.__webglColorRenderbuffer.length;ot++)M.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ot]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ut=R.textures;for(let ot=0,xt=ut.length;ot<xt;ot++){let vt=i.get(ut[ot]);vt.__webglTexture&&(n.deleteTexture(vt.__webglTexture),o.memory.textures--),i.remove(ut[ot])}i.remove(R)}let Z=0;function j(){Z=0}function et(){return Z}function ft(R){Z=R}function dt(){let R=Z;return R>=s.maxTextures&&Jt("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,R}function tt(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function gt(R,M){let X=i.get(R);if(R.isVideoTexture&&Be(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let ut=R.image;if(ut===null)Jt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)Jt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(X,R,M);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+M)}function yt(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Ve(X,R,M);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+M)}function Ct(R,M){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){Ve(X,R,M);return}e.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+M)}function bt(R,M){let X=i.get(R);if(R.version>0&&X.__version!==R.version){ln(X,R,M);return}e.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+M)}let $t={[Pc]:n.REPEAT,[hs]:n.CLAMP_TO_EDGE,[Ic]:n.MIRRORED_REPEAT},ae={[On]:n.NEAREST,[Ng]:n.NEAREST_MIPMAP_NEAREST,[ll]:n.NEAREST_MIPMAP_LINEAR,[ei]:n.LINEAR,[oh]:n.LINEAR_MIPMAP_NEAREST,[Bs]:n.LINEAR_MIPMAP_LINEAR},Ht={[Bg]:n.NEVER,[Yd]:n.ALWAYS,[zg]:n.LESS,[Xd]:n.LEQUAL,[kg]:n.EQUAL,[$d]:n.GEQUAL,[Vg]:n.GREATER,[Gg]:n.NOTEQUAL};function pe(R,M){if(M.type===Ui&&t.has("OES_texture_float_linear")===!1&&(M.magFilter===ei||M.magFilter===oh||M.magFilter===ll||M.magFilter===Bs||M.minFilter===ei||M.minFilter===oh||M.minFilter===ll||M.minFilter===Bs)&&Jt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,$t[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,$t[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,$t[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ae[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ae[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ht[M.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===On||M.minFilter!==ll&&M.minFilter!==Bs||M.type===Ui&&t.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let X=t.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ue(R,M){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),O(M));let ut=M.source,ot=f.get(ut);ot===void 0&&(ot={},f.set(ut,ot));let xt=tt(M);if(xt!==R.__cacheKey){ot[xt]===void 0&&(ot[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ot[xt].usedTimes++;let vt=ot[R.__cacheKey];vt!==void 0&&(ot[R.__cacheKey].usedTimes--,vt.usedTimes===0&&G(M)),R.__cacheKey=xt,R.__webglTexture=ot[xt].texture}return X}function re(R,M,X){return Math.floor(Math.floor(R/X)/M)}function Je(R,M,X,ut){let xt=R.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,X,ut,M.data);else{xt.sort((F,rt)=>F.start-rt.start);let vt=0;for(let F=1;F<xt.length;F++){let rt=xt[vt],it=xt[F],Et=rt.start+rt.count,_t=re(it.start,M.width,4),Mt=re(rt.start,M.width,4);it.start<=Et+1&&_t===Mt&&re(it.start+it.count-1,M.width,4)===_t?rt.count=Math.max(rt.count,it.start+it.count-rt.start):(++vt,xt[vt]=it)}xt.length=vt+1;let nt=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,rt=xt.length;F<rt;F++){let it=xt[F],Et=Math.floor(it.start/4),_t=Math.ceil(it.count/4),Mt=Et%M.width,Wt=Math.floor(Et/M.width),Qt=_t,ht=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,Mt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Wt),e.texSubImage2D(n.TEXTURE_2D,0,Mt,Wt,Qt,ht,X,ut,M.data)}R.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,nt),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ve(R,M,X){let ut=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ut=n.TEXTURE_3D);let ot=ue(R,M),xt=M.source;e.bindTexture(ut,R.__webglTexture,n.TEXTURE0+X);let vt=i.get(xt);if(xt.version!==vt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ht=Se.getPrimaries(Se.workingColorSpace),zt=M.colorSpace===ks?null:Se.getPrimaries(M.colorSpace),te=M.colorSpace===ks||ht===zt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,te)}e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let st=v(M.image,!1,s.maxTextureSize);st=Gt(M,st);let mt=r.convert(M.format,M.colorSpace),F=r.convert(M.type),rt=A(M.internalFormat,mt,F,M.normalized,M.colorSpace,M.isVideoTexture);pe(ut,M);let it,Et=M.mipmaps,_t=M.isVideoTexture!==!0,Mt=vt.__version===void 0||ot===!0,Wt=xt.dataReady,Qt=E(M,st);if(M.isDepthTexture)rt=x(M.format===zs,M.type),Mt&&(_t?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,F,null));else if(M.isDataTexture)if(Et.length>0){_t&&Mt&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ht=0,zt=Et.length;ht<zt;ht++)it=Et[ht],_t?Wt&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,F,it.data):e.texImage2D(n.TEXTURE_2D,ht,rt,it.width,it.height,0,mt,F,it.data);M.generateMipmaps=!1}else _t?(Mt&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,st.width,st.height),Wt&&Je(M,st,mt,F)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,F,st.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_t&&Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,rt,Et[0].width,Et[0].height,st.depth);for(let ht=0,zt=Et.length;ht<zt;ht++)if(it=Et[ht],M.format!==ji)if(mt!==null)if(_t){if(Wt)if(M.layerUpdates.size>0){let te=sf(it.width,it.height,M.format,M.type);for(let Rt of M.layerUpdates){let he=it.data.subarray(Rt*te/it.data.BYTES_PER_ELEMENT,(Rt+1)*te/it.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,Rt,it.width,it.height,1,mt,he)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,st.depth,mt,it.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ht,rt,it.width,it.height,st.depth,0,it.data,0,0);else Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Wt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ht,0,0,0,it.width,it.height,st.depth,mt,F,it.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ht,rt,it.width,it.height,st.depth,0,mt,F,it.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_t&&Mt&&e.texStorage2D(n.TEXTURE_2D,Qt,rt,Et[0].width,Et[0].height);for(let ht=0,zt=Et.length;ht<zt;ht++)it=Et[ht],M.format!==ji?mt!==null?_t?Wt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,it.data):e.compressedTexImage2D(n.TEXTURE_2D,ht,rt,it.width,it.height,0,it.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Wt&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,it.width,it.height,mt,F,it.data):e.texImage2D(n.TEXTURE_2D,ht,rt,it.width,it.height,0,mt,F,it.data)}else if(M.isDataArrayTexture)if(_t){if(Mt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Qt,rt,st.width,st.height,st.depth),Wt)if(M.layerUpdates.size>0){let ht=sf(st.width,st.height,M.format,M.type);for(let zt of M.layerUpdates){let te=st.data.subarray(zt*ht/st.data.BYTES_PER_ELEMENT,(zt+1)*ht/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,zt,st.width,st.height,1,mt,F,te)}M.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,F,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,F,st.data);else if(M.isData3DTexture)_t?(Mt&&e.texStorage3D(n.TEXTURE_3D,Qt,rt,st.width,st.height,st.depth),Wt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,F,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,F,st.data);else if(M.isFramebufferTexture){if(Mt)if(_t)e.texStorage2D(n.TEXTURE_2D,Qt,rt,st.width,st.height);else{let ht=st.width,zt=st.height;for(let te=0;te<Qt;te++)e.texImage2D(n.TEXTURE_2D,te,rt,ht,zt,0,mt,F,null),ht>>=1,zt>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ht=n.canvas;if(ht.hasAttribute("layoutsubtree")||ht.setAttribute("layoutsubtree","true"),st.parentNode!==ht){ht.appendChild(st),u.add(M),ht.onpaint=zt=>{let te=zt.changedElements;for(let Rt of u)te.includes(Rt.image)&&(Rt.needsUpdate=!0)},ht.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let te=n.RGBA,Rt=n.RGBA,he=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,te,Rt,he,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Et.length>0){if(_t&&Mt){let ht=qt(Et[0]);e.texStorage2D(n.TEXTURE_2D,Qt,rt,ht.width,ht.height)}for(let ht=0,zt=Et.length;ht<zt;ht++)it=Et[ht],_t?Wt&&e.texSubImage2D(n.TEXTURE_2D,ht,0,0,mt,F,it):e.texImage2D(n.TEXTURE_2D,ht,rt,mt,F,it);M.generateMipmaps=!1}else if(_t){if(Mt){let ht=qt(st);e.texStorage2D(n.TEXTURE_2D,Qt,rt,ht.width,ht.height)}Wt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,F,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,F,st);T(M)&&M.mipmapsAutoUpdate===!0&&S(ut),vt.__version=xt.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function ln(R,M,X){if(M.image.length!==6)return;let ut=ue(R,M),ot=M.source;e.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let xt=i.get(ot);if(ot.version!==xt.__version||ut===!0){e.activeTexture(n.TEXTURE0+X);let vt=Se.getPrimaries(Se.workingColorSpace),nt=M.colorSpace===ks?null:Se.getPrimaries(M.colorSpace),st=M.colorSpace===ks||vt===nt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,rt=[];for(let Rt=0;Rt<6;Rt++)!mt&&!F?rt[Rt]=v(M.image[Rt],!0,s.maxCubemapSize):rt[Rt]=F?M.image[Rt].image:M.image[Rt],rt[Rt]=Gt(M,rt[Rt]);let it=rt[0],Et=r.convert(M.format,M.colorSpace),_t=r.convert(M.type),Mt=A(M.internalFormat,Et,_t,M.normalized,M.colorSpace),Wt=M.isVideoTexture!==!0,Qt=xt.__version===void 0||ut===!0,ht=ot.dataReady,zt=E(M,it);pe(n.TEXTURE_CUBE_MAP,M);let te;if(M.isDepthTexture){if(Mt=x(M.format===zs,M.type),Qt)if(Wt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,Mt,it.width,it.height);else for(let Rt=0;Rt<6;Rt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,it.width,it.height,0,Et,_t,null)}else if(mt){Wt&&Qt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,zt,Mt,it.width,it.height);for(let Rt=0;Rt<6;Rt++){te=rt[Rt].mipmaps;for(let he=0;he<te.length;he++){let He=te[he];M.format!==ji?Et!==null?Wt?ht&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,He.width,He.height,Et,He.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,Mt,He.width,He.height,0,He.data):Jt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Wt?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,0,0,He.width,He.height,Et,_t,He.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he,Mt,He.width,He.height,0,Et,_t,He.data)}}}else{if(te=M.mipmaps,Wt&&Qt){te.length>0&&zt++;let Rt=qt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,zt,Mt,Rt.width,Rt.height)}for(let Rt=0;Rt<6;Rt++)if(F){Wt?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,rt[Rt].width,rt[Rt].height,Et,_t,rt[Rt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,rt[Rt].width,rt[Rt].height,0,Et,_t,rt[Rt].data);for(let he=0;he<te.length;he++){let Zn=te[he].image[Rt].image;Wt?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,Zn.width,Zn.height,Et,_t,Zn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,Mt,Zn.width,Zn.height,0,Et,_t,Zn.data)}}else{Wt?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,0,0,Et,_t,rt[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,0,Mt,Et,_t,rt[Rt]);for(let he=0;he<te.length;he++){let He=te[he];Wt?ht&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,0,0,Et,_t,He.image[Rt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Rt,he+1,Mt,Et,_t,He.image[Rt])}}}T(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xt.__version=ot.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ue(R,M,X,ut,ot,xt){let vt=r.convert(X.format,X.colorSpace),nt=r.convert(X.type),st=A(X.internalFormat,vt,nt,X.normalized,X.colorSpace),mt=i.get(M),F=i.get(X);if(F.__renderTarget=M,!mt.__hasExternalTextures){let rt=Math.max(1,M.width>>xt),it=Math.max(1,M.height>>xt);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,xt,st,rt,it,M.depth,0,vt,nt,null):e.texImage2D(ot,xt,st,rt,it,0,vt,nt,null)}e.bindFramebuffer(n.FRAMEBUFFER,R),wt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,ot,F.__webglTexture,0,le(M)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,ot,F.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Rn(R,M,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ut=M.depthTexture,ot=ut&&ut.isDepthTexture?ut.type:null,xt=x(M.stencilBuffer,ot),vt=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(M),xt,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(M),xt,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xt,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,vt,n.RENDERBUFFER,R)}else{let ut=M.textures;for(let ot=0;ot<ut.length;ot++){let xt=ut[ot],vt=r.convert(xt.format,xt.colorSpace),nt=r.convert(xt.type),st=A(xt.internalFormat,vt,nt,xt.normalized,xt.colorSpace);wt(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,le(M),st,M.width,M.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,le(M),st,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,st,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function be(R,M,X){let ut=M.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(M.depthTexture);ot.__renderTarget=M;let xt=ut?M.depthTexture.image[0]:M.depthTexture.image;(!ot.__webglTexture||xt.width!==M.width||xt.height!==M.height)&&(xt.width=M.width,xt.height=M.height,M.depthTexture.needsUpdate=!0),ut?bt(M.depthTexture,0):gt(M.depthTexture,0);let vt=ot.__webglTexture,nt=le(M),st=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,mt=M.depthTexture.format===zs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Os)wt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,vt,0);else if(M.depthTexture.format===zs)wt(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,vt,0,nt):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,vt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function yn(R){let M=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ut=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ut){let ot=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ut.removeEventListener("dispose",ot)};ut.addEventListener("dispose",ot),M.__depthDisposeCallback=ot}M.__boundDepthTexture=ut}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(X)for(let ut=0;ut<6;ut++)be(M.__webglFramebuffer[ut],R,ut);else R.texture.mipmaps.length>0?be(M.__webglFramebuffer[0],R,0):be(M.__webglFramebuffer,R,0);else if(X){M.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ut]),M.__webglDepthbuffer[ut]===void 0)M.__webglDepthbuffer[ut]=n.createRenderbuffer(),Rn(M.__webglDepthbuffer[ut],R,!1);else{let ot=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=M.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Rn(M.__webglDepthbuffer,R,!1);else{let ot=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function tn(R,M,X){let ut=i.get(R);M!==void 0&&Ue(ut.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&yn(R)}function cn(R){let M=R.texture,X=i.get(R),ut=i.get(M);R.addEventListener("dispose",z),O(R);let ot=R.textures,xt=R.isWebGLCubeRenderTarget===!0,vt=ot.length>1;if(vt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=M.version,o.memory.textures++),xt){X.__webglFramebuffer=[];for(let nt=0;nt<6;nt++)if(M.mipmaps.length>0){X.__webglFramebuffer[nt]=[];for(let st=0;st<M.mipmaps.length;st++)X.__webglFramebuffer[nt][st]=n.createFramebuffer()}else X.__webglFramebuffer[nt]=n.createFramebuffer()}else{if(M.mipmaps.length>0){X.__webglFramebuffer=[];for(let nt=0;nt<M.mipmaps.length;nt++)X.__webglFramebuffer[nt]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(vt)for(let nt=0,st=ot.length;nt<st;nt++){let mt=i.get(ot[nt]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&wt(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let nt=0;nt<ot.length;nt++){let st=ot[nt];X.__webglColorRenderbuffer[nt]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[nt]);let mt=r.convert(st.format,st.colorSpace),F=r.convert(st.type),rt=A(st.internalFormat,mt,F,st.normalized,st.colorSpace,R.isXRRenderTarget===!0),it=le(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,it,rt,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+nt,n.RENDERBUFFER,X.__webglColorRenderbuffer[nt])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Rn(X.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),pe(n.TEXTURE_CUBE_MAP,M);for(let nt=0;nt<6;nt++)if(M.mipmaps.length>0)for(let st=0;st<M.mipmaps.length;st++)Ue(X.__webglFramebuffer[nt][st],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,st);else Ue(X.__webglFramebuffer[nt],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+nt,0);T(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}else if(vt){for(let nt=0,st=ot.length;nt<st;nt++){let mt=ot[nt],F=i.get(mt),rt=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(rt=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,F.__webglTexture),pe(rt,mt),Ue(X.__webglFramebuffer,R,mt,n.COLOR_ATTACHMENT0+nt,rt,0),T(mt)&&S(rt)}e.unbindTexture()}else{let nt=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(nt=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(nt,ut.__webglTexture),pe(nt,M),M.mipmaps.length>0)for(let st=0;st<M.mipmaps.length;st++)Ue(X.__webglFramebuffer[st],R,M,n.COLOR_ATTACHMENT0,nt,st);else Ue(X.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,nt,0);T(M)?S(nt):M.mipmaps.length>0&&n.texParameteri(nt,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&yn(R)}function B(R){let M=R.textures;for(let X=0,ut=M.length;X<ut;X++){let ot=M[X];if(T(ot)&&ot.mipmapsAutoUpdate===!0){let xt=C(R),vt=i.get(ot).__webglTexture;e.bindTexture(xt,vt),S(xt),e.unbindTexture()}}}let Pt=[];function Kt(R){if(R.samples>0){if(wt(R)===!1){let M=R.textures,X=R.width,ut=R.height,ot=n.COLOR_BUFFER_BIT,xt=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,vt=i.get(R),nt=M.length>1;if(nt)for(let mt=0;mt<M.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,vt.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglFramebuffer);for(let mt=0;mt<M.length;mt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),nt){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,vt.__webglColorRenderbuffer[mt]);let F=i.get(M[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,ut,0,0,X,ut,ot,n.NEAREST),l===!0&&(Pt.length=0,Pt.push(n.COLOR_ATTACHMENT0+mt),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Pt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),nt)for(let mt=0;mt<M.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,vt.__webglColorRenderbuffer[mt]);let F=i.get(M[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,vt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,F,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,vt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function le(R){return Math.min(s.maxSamples,R.samples)}function wt(R){let M=i.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Be(R){let M=o.render.frame;h.get(R)!==M&&(h.set(R,M),R.update())}function Gt(R,M){let X=R.colorSpace,ut=R.format,ot=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Na&&X!==ks&&(Se.getTransfer(X)===Re?(ut!==ji||ot!==li)&&Jt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):ee("WebGLTextures: Unsupported texture color space:",X)),M}function qt(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=j,this.getTextureUnits=et,this.setTextureUnits=ft,this.setTexture2D=gt,this.setTexture2DArray=yt,this.setTexture3D=Ct,this.setTextureCube=bt,this.rebindTextures=tn,this.setupRenderTarget=cn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Kt,this.setupDepthRenderbuffer=yn,this.setupFrameBufferTexture=Ue,this.useMultisampledRTT=wt,this.dispose=H}function uA(n,t){function e(i,s=ks){let r,o=Se.getTransfer(s);if(i===li)return n.UNSIGNED_BYTE;if(i===lh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ch)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Vd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Gd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===zd)return n.BYTE;if(i===kd)return n.SHORT;if(i===$o)return n.UNSIGNED_SHORT;if(i===ah)return n.INT;if(i===Ji)return n.UNSIGNED_INT;if(i===Ui)return n.FLOAT;if(i===Ki)return n.HALF_FLOAT;if(i===Hd)return n.ALPHA;if(i===Wd)return n.RGB;if(i===ji)return n.RGBA;if(i===Os)return n.DEPTH_COMPONENT;if(i===zs)return n.DEPTH_STENCIL;if(i===hh)return n.RED;if(i===uh)return n.RED_INTEGER;if(i===pr)return n.RG;if(i===dh)return n.RG_INTEGER;if(i===fh)return n.RGBA_INTEGER;if(i===cl||i===hl||i===ul||i===dl)if(o===Re)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===cl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===hl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===dl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===cl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===hl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ul)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===dl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ph||i===mh||i===gh||i===_h)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===ph)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===mh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===gh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===_h)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===xh||i===yh||i===vh||i===Sh||i===Mh||i===fl||i===bh)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===xh||i===yh)return o===Re?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===vh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Sh)return r.COMPRESSED_R11_EAC;if(i===Mh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===fl)return r.COMPRESSED_RG11_EAC;if(i===bh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===wh||i===Eh||i===Ah||i===Th||i===Ch||i===Rh||i===Ph||i===Ih||i===Lh||i===Dh||i===Nh||i===Uh||i===Oh||i===Fh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===wh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Eh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Ah)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Th)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ch)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Rh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ph)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ih)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Lh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Dh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Nh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Uh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Oh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Fh)return o===Re?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Bh||i===zh||i===kh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Bh)return o===Re?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===zh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===kh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Vh||i===Gh||i===pl||i===Hh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Vh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Gh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===pl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Hh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===zr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var dA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,fA=`
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

}`,xf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Ya(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ni({vertexShader:dA,fragmentShader:fA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ge(new Za(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},yf=class extends qi{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,f=null,m=null,_=typeof XRWebGLBinding<"u",g=new xf,p={},v=e.getContextAttributes(),T=null,S=null,C=[],A=[],x=new Zt,E=null,O=null,I=new vi;I.viewport=new Pe;let L=new vi;L.viewport=new Pe;let z=[I,L],V=new eh,D=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let gt=C[tt];return gt===void 0&&(gt=new Fo,C[tt]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(tt){let gt=C[tt];return gt===void 0&&(gt=new Fo,C[tt]=gt),gt.getGripSpace()},this.getHand=function(tt){let gt=C[tt];return gt===void 0&&(gt=new Fo,C[tt]=gt),gt.getHandSpace()};function $(tt){let gt=A.indexOf(tt.inputSource);if(gt===-1)return;let yt=C[gt];yt!==void 0&&(yt.update(tt.inputSource,tt.frame,c||o),yt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<C.length;tt++){let gt=A[tt];gt!==null&&(A[tt]=null,C[tt].disconnect(gt))}D=null,H=null,g.reset();for(let tt in p)delete p[tt];if(t.setRenderTarget(T),f=null,d=null,u=null,s=null,S=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(E),t.setSize(x.width,x.height,!1),O!==null){let tt=O.camera;tt.fov=O.fov,tt.zoom=O.zoom,tt.updateProjectionMatrix(),O=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&Jt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&Jt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return m},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",lt),v.xrCompatible!==!0&&await e.makeXRCompatible(),E=t.getPixelRatio(),t.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let yt=null,Ct=null,bt=null;v.depth&&(bt=v.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,yt=v.stencil?zs:Os,Ct=v.stencil?zr:Ji);let $t={colorFormat:e.RGBA8,depthFormat:bt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer($t),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),S=new Mi(d.textureWidth,d.textureHeight,{format:ji,type:li,depthTexture:new Fs(d.textureWidth,d.textureHeight,Ct,void 0,void 0,void 0,void 0,void 0,void 0,yt),stencilBuffer:v.stencil,colorSpace:t.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let yt={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,yt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new Mi(f.framebufferWidth,f.framebufferHeight,{format:ji,type:li,colorSpace:t.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function lt(tt){for(let gt=0;gt<tt.removed.length;gt++){let yt=tt.removed[gt],Ct=A.indexOf(yt);Ct>=0&&(A[Ct]=null,C[Ct].disconnect(yt))}for(let gt=0;gt<tt.added.length;gt++){let yt=tt.added[gt],Ct=A.indexOf(yt);if(Ct===-1){for(let $t=0;$t<C.length;$t++)if($t>=A.length){A.push(yt),Ct=$t;break}else if(A[$t]===null){A[$t]=yt,Ct=$t;break}if(Ct===-1)break}let bt=C[Ct];bt&&bt.connect(yt)}}function Z(tt,gt){gt===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(gt.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let gt=tt.near,yt=tt.far;g.texture!==null&&(g.depthNear>0&&(gt=g.depthNear),g.depthFar>0&&(yt=g.depthFar)),V.near=L.near=I.near=gt,V.far=L.far=I.far=yt,(D!==V.near||H!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),D=V.near,H=V.far),V.layers.mask=tt.layers.mask|6,I.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let Ct=tt.parent,bt=V.cameras;Z(V,Ct);for(let $t=0;$t<bt.length;$t++)Z(bt[$t],Ct);V.projectionMatrix.copy(I.projectionMatrix),V.projectionMatrixInverse.copy(I.projectionMatrixInverse),O===null&&tt.isPerspectiveCamera&&(O={camera:tt,fov:tt.fov,zoom:tt.zoom}),j(tt,V,Ct)};function j(tt,gt,yt){yt===null?tt.matrix.copy(gt.matrixWorld):(tt.matrix.copy(yt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(gt.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(gt.projectionMatrix),tt.projectionMatrixInverse.copy(gt.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=No*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(tt){return p[tt]};let et=null;function ft(tt,gt){if(h=gt.getViewerPose(c||o),m=gt,h!==null){let yt=h.views;f!==null&&(t.setRenderTargetFramebuffer(S,f.framebuffer),t.setRenderTarget(S));let Ct=!1;yt.length!==V.cameras.length&&(V.cameras.length=0,Ct=!0);for(let Ht=0;Ht<yt.length;Ht++){let pe=yt[Ht],ue=null;if(f!==null)ue=f.getViewport(pe);else{let Je=u.getViewSubImage(d,pe);ue=Je.viewport,Ht===0&&(t.setRenderTargetTextures(S,Je.colorTexture,Je.depthStencilTexture),t.setRenderTarget(S))}let re=z[Ht];re===void 0&&(re=new vi,re.layers.enable(Ht),re.viewport=new Pe,z[Ht]=re),re.matrix.fromArray(pe.transform.matrix),re.matrix.decompose(re.position,re.quaternion,re.scale),re.projectionMatrix.fromArray(pe.projectionMatrix),re.projectionMatrixInverse.copy(re.projectionMatrix).invert(),re.viewport.set(ue.x,ue.y,ue.width,ue.height),Ht===0&&(V.matrix.copy(re.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ct===!0&&V.cameras.push(re)}let bt=s.enabledFeatures;if(bt&&bt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=i.getBinding();let Ht=u.getDepthInformation(yt[0]);Ht&&Ht.isValid&&Ht.texture&&g.init(Ht,s.renderState)}if(bt&&bt.includes("camera-access")&&_){t.state.unbindTexture(),u=i.getBinding();for(let Ht=0;Ht<yt.length;Ht++){let pe=yt[Ht].camera;if(pe){let ue=p[pe];ue||(ue=new Ya,p[pe]=ue);let re=u.getCameraImage(pe);ue.sourceTexture=re}}}}for(let yt=0;yt<C.length;yt++){let Ct=A[yt],bt=C[yt];Ct!==null&&bt!==void 0&&bt.update(Ct,gt,c||o)}et&&et(tt,gt),gt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:gt}),m=null}let dt=new _0;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){et=tt},this.dispose=function(){}}},pA=new xe,T0=new se;T0.set(-1,0,0,0,1,0,0,0,1);function mA(n,t){function e(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,tf(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function s(g,p,v,T,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(g,p):p.isMeshLambertMaterial?(r(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(g,p),u(g,p)):p.isMeshPhongMaterial?(r(g,p),h(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(g,p),d(g,p),p.isMeshPhysicalMaterial&&f(g,p,S)):p.isMeshMatcapMaterial?(r(g,p),m(g,p)):p.isMeshDepthMaterial?r(g,p):p.isMeshDistanceMaterial?(r(g,p),_(g,p)):p.isMeshNormalMaterial?r(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,v,T):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,e(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===ni&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,e(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===ni&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,e(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,e(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let v=t.get(p),T=v.envMap,S=v.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(pA.makeRotationFromEuler(S)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(T0),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,v,T){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*v,g.scale.value=T*.5,p.map&&(g.map.value=p.map,e(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,e(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,e(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function h(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function u(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function d(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,v){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ni&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function _(g,p){let v=t.get(p).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function gA(n,t,e,i){let s={},r={};function o(v,T){let S=T.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,T){let S=s[v.id];S===void 0&&(m(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",g));let C=T.program;i.updateUBOMapping(v,C);let A=t.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let T=n.createBuffer(),S=v.__size,C=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,S,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],S=v.uniforms,C=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let A=0,x=S.length;A<x;A++){let E=S[A];if(Array.isArray(E))for(let O=0,I=E.length;O<I;O++)h(E[O],A,O,C);else h(E,A,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(v,T,S,C){if(d(v,T,S,C)===!0){let A=v.__offset,x=v.value;if(Array.isArray(x)){let E=0;for(let O=0;O<x.length;O++){let I=x[O],L=_(I,!0);u(I,v.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,A,v.__data)}}function u(v,T,S){typeof v=="number"||typeof v=="boolean"?T[S]=v:v.isMatrix3?(T[S]=v.elements[0],T[S+1]=v.elements[1],T[S+2]=v.elements[2],T[S+3]=0,T[S+4]=v.elements[3],T[S+5]=v.elements[4],T[S+6]=v.elements[5],T[S+7]=0,T[S+8]=v.elements[6],T[S+9]=v.elements[7],T[S+10]=v.elements[8],T[S+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-S),S):v.toArray(T,S)}function d(v,T,S,C){let A=v.value,x=T+"_"+S;if(Array.isArray(A)){C[x]===void 0&&(C[x]=[]);let E=C[x],O=!1;for(let I=0;I<A.length;I++)f(A[I],E,I)===!0&&(O=!0);return O}return f(A,C,x)}function f(v,T,S){if(T[S]===void 0)return typeof v=="number"||typeof v=="boolean"?T[S]=v:ArrayBuffer.isView(v)?T[S]=v.slice():T[S]=v.clone(),!0;{let C=T[S];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function m(v){let T=v.uniforms,S=0,C=16;for(let x=0,E=T.length;x<E;x++){let O=Array.isArray(T[x])?T[x]:[T[x]];for(let I=0,L=O.length;I<L;I++){let z=O[I],V=Array.isArray(z.value)?z.value:[z.value],D=Array.isArray(T[x])||Array.isArray(z.value),H=S;for(let G=0,lt=V.length;G<lt;G++){let Z=V[G],j=_(Z,D),et=S%C,ft=et%j.boundary,dt=et+ft;S+=ft,dt!==0&&C-dt<j.storage&&(S+=C-dt),G===0&&(H=S),S+=j.storage}let $=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new $((S-H)/Float32Array.BYTES_PER_ELEMENT),z.__offset=H}}let A=S%C;return A>0&&(S+=C-A),v.__size=S,v.__cache={},this}function _(v,T){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Jt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Jt("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(v){let T=v.target;T.removeEventListener("dispose",g),n.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var _A=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ps=null;function xA(){return ps===null&&(ps=new Ha(_A,16,16,pr,Ki),ps.name="DFG_LUT",ps.minFilter=ei,ps.magFilter=ei,ps.wrapS=hs,ps.wrapT=hs,ps.generateMipmaps=!1,ps.needsUpdate=!0),ps}var qh=class{constructor(t={}){let{canvas:e=Hg(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=li}=t;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let _=f,g=new Set([fh,dh,uh]),p=new Set([li,Ji,$o,zr,lh,ch]),v=new Uint32Array(4),T=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},C=null,A=null,x=[],E=[],O=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=fs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,L=!1,z=null,V=null,D=null,H=null;this._outputColorSpace=xi;let $=0,G=0,lt=null,Z=-1,j=null,et=new Pe,ft=new Pe,dt=null,tt=new ne(0),gt=0,yt=e.width,Ct=e.height,bt=1,$t=null,ae=null,Ht=new Pe(0,0,yt,Ct),pe=new Pe(0,0,yt,Ct),ue=!1,re=new ir,Je=new Fc,Ve=!1,ln=!1,Ue=new xe,Rn=new U,be=new Pe,yn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function cn(){return lt===null?bt:1}let B=i;function Pt(w,k){return e.getContext(w,k)}let Kt,le,wt,Be,Gt,qt,R,M,X,ut,ot,xt,vt,nt,st,mt,F,rt,it,Et,_t,Mt,Wt;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",zt,!1),e.addEventListener("webglcontextrestored",te,!1),e.addEventListener("webglcontextcreationerror",Rt,!1),B===null){let k="webgl2";if(B=Pt(k,w),B===null)throw Pt(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Qt()}catch(w){throw e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),ee("WebGLRenderer: "+w.message),w}function Qt(){Kt=new RE(B),Kt.init(),_t=new uA(B,Kt),le=new xE(B,Kt,t,_t),wt=new cA(B,Kt),le.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),V=B.createFramebuffer(),D=B.createFramebuffer(),H=B.createFramebuffer(),Be=new LE(B),Gt=new Z1,qt=new hA(B,Kt,wt,Gt,le,_t,Be),R=new CE(I),M=new NM(B),Mt=new gE(B,M),X=new PE(B,M,Be,Mt),ut=new NE(B,X,M,Mt,Be),rt=new DE(B,le,qt),st=new yE(Gt),ot=new q1(I,R,Kt,le,Mt,st),xt=new mA(I,Gt),vt=new K1,nt=new iA(Kt),F=new mE(I,R,wt,ut,m,l),mt=new lA(I,ut,le),Wt=new gA(B,Be,le,wt),it=new _E(B,Kt,Be),Et=new IE(B,Kt,Be),Be.programs=ot.programs,I.capabilities=le,I.extensions=Kt,I.properties=Gt,I.renderLists=vt,I.shadowMap=mt,I.state=wt,I.info=Be}_!==li&&(O=new OE(_,e.width,e.height,a,s,r));let ht=new yf(I,B);this.xr=ht,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let w=Kt.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=Kt.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return bt},this.setPixelRatio=function(w){w!==void 0&&(bt=w,this.setSize(yt,Ct,!1))},this.getSize=function(w){return w.set(yt,Ct)},this.setSize=function(w,k,Q=!0){if(ht.isPresenting){Jt("WebGLRenderer: Can't change size while VR device is presenting.");return}yt=w,Ct=k,e.width=Math.floor(w*bt),e.height=Math.floor(k*bt),Q===!0&&(e.style.width=w+"px",e.style.height=k+"px"),O!==null&&O.setSize(e.width,e.height),this.setViewport(0,0,w,k)},this.getDrawingBufferSize=function(w){return w.set(yt*bt,Ct*bt).floor()},this.setDrawingBufferSize=function(w,k,Q){yt=w,Ct=k,bt=Q,e.width=Math.floor(w*Q),e.height=Math.floor(k*Q),this.setViewport(0,0,w,k)},this.setEffects=function(w){if(_===li){ee("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let k=0;k<w.length;k++)if(w[k].isOutputPass===!0){Jt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(et)},this.getViewport=function(w){return w.copy(Ht)},this.setViewport=function(w,k,Q,Y){w.isVector4?Ht.set(w.x,w.y,w.z,w.w):Ht.set(w,k,Q,Y),wt.viewport(et.copy(Ht).multiplyScalar(cn()).round())},this.getScissor=function(w){return w.copy(pe)},this.setScissor=function(w,k,Q,Y){w.isVector4?pe.set(w.x,w.y,w.z,w.w):pe.set(w,k,Q,Y),wt.scissor(ft.copy(pe).multiplyScalar(cn()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(w){wt.setScissorTest(ue=w)},this.setOpaqueSort=function(w){$t=w},this.setTransparentSort=function(w){ae=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,k=!0,Q=!0){let Y=0;if(w){let J=!1;if(lt!==null){let At=lt.texture.format;J=g.has(At)}if(J){let At=lt.texture.type,Lt=p.has(At),Tt=F.getClearColor(),Dt=F.getClearAlpha(),Vt=Tt.r,ie=Tt.g,me=Tt.b;Lt?(v[0]=Vt,v[1]=ie,v[2]=me,v[3]=Dt,B.clearBufferuiv(B.COLOR,0,v)):(T[0]=Vt,T[1]=ie,T[2]=me,T[3]=Dt,B.clearBufferiv(B.COLOR,0,T))}else Y|=B.COLOR_BUFFER_BIT}k&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),z=w},this.dispose=function(){e.removeEventListener("webglcontextlost",zt,!1),e.removeEventListener("webglcontextrestored",te,!1),e.removeEventListener("webglcontextcreationerror",Rt,!1),F.dispose(),vt.dispose(),nt.dispose(),qt.dispose(),Gt.dispose(),R.dispose(),ut.dispose(),X.dispose(),Mt.dispose(),Wt.dispose(),ot.dispose(),ht.dispose(),ht.removeEventListener("sessionstart",Gl),ht.removeEventListener("sessionend",ns),bs.stop()};function zt(w){w.preventDefault(),Fa("WebGLRenderer: Context Lost."),L=!0}function te(){Fa("WebGLRenderer: Context Restored."),L=!1;let w=Be.autoReset,k=mt.enabled,Q=mt.autoUpdate,Y=mt.needsUpdate,J=mt.type;Qt(),Be.autoReset=w,mt.enabled=k,mt.autoUpdate=Q,mt.needsUpdate=Y,mt.type=J}function Rt(w){ee("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function he(w){let k=w.target;k.removeEventListener("dispose",he),He(k)}function He(w){Zn(w),Gt.remove(w)}function Zn(w){let k=Gt.get(w).programs;k!==void 0&&(k.forEach(function(Q){ot.releaseProgram(Q)}),w.isShaderMaterial&&ot.releaseShaderCache(w))}this.renderBufferDirect=function(w,k,Q,Y,J,At){k===null&&(k=yn);let Lt=J.isMesh&&J.matrixWorld.determinantAffine()<0,Tt=ya(w,k,Q,Y,J);wt.setMaterial(Y,Lt);let Dt=Q.index,Vt=1;if(Y.wireframe===!0){if(Dt=X.getWireframeAttribute(Q),Dt===void 0)return;Vt=2}let ie=Q.drawRange,me=Q.attributes.position,kt=ie.start*Vt,ge=(ie.start+ie.count)*Vt;At!==null&&(kt=Math.max(kt,At.start*Vt),ge=Math.min(ge,(At.start+At.count)*Vt)),Dt!==null?(kt=Math.max(kt,0),ge=Math.min(ge,Dt.count)):me!=null&&(kt=Math.max(kt,0),ge=Math.min(ge,me.count));let je=ge-kt;if(je<0||je===1/0)return;Mt.setup(J,Y,Tt,Q,Dt);let Le,De=it;if(Dt!==null&&(Le=M.get(Dt),De=Et,De.setIndex(Le)),J.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*cn()),De.setMode(B.LINES)):De.setMode(B.TRIANGLES);else if(J.isLine){let vn=Y.linewidth;vn===void 0&&(vn=1),wt.setLineWidth(vn*cn()),J.isLineSegments?De.setMode(B.LINES):J.isLineLoop?De.setMode(B.LINE_LOOP):De.setMode(B.LINE_STRIP)}else J.isPoints?De.setMode(B.POINTS):J.isSprite&&De.setMode(B.TRIANGLES);if(J.isBatchedMesh)if(Kt.get("WEBGL_multi_draw"))De.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let vn=J._multiDrawStarts,Ft=J._multiDrawCounts,hn=J._multiDrawCount,ve=Dt?M.get(Dt).bytesPerElement:1,Es=Gt.get(Y).currentProgram.getUniforms();for(let un=0;un<hn;un++)Es.setValue(B,"_gl_DrawID",un),De.render(vn[un]/ve,Ft[un])}else if(J.isInstancedMesh)De.renderInstances(kt,je,J.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ft=Math.min(Q.instanceCount,vn);De.renderInstances(kt,je,Ft)}else De.render(kt,je)};function ga(w,k,Q,Y){z!==null&&w.isNodeMaterial&&z.setObject(Y,w),Ve===!0&&st.setState(w,Q,!1),w.transparent===!0&&w.side===Fn&&w.forceSinglePass===!1?(w.side=ni,w.needsUpdate=!0,is(w,k,Y),w.side=fr,w.needsUpdate=!0,is(w,k,Y),w.side=Fn):is(w,k,Y)}this.compile=function(w,k,Q=null){Q===null&&(Q=w),z!==null&&z.renderStart(w,k,Q),A=nt.get(Q),A.init(k),E.push(A),Q.traverseVisible(function(J){J.isLight&&J.layers.test(k.layers)&&(A.pushLight(J),J.castShadow&&A.pushShadow(J))}),w!==Q&&w.traverseVisible(function(J){J.isLight&&J.layers.test(k.layers)&&(A.pushLight(J),J.castShadow&&A.pushShadow(J))}),A.setupLights(),z!==null&&z.updateLights(A.state.lightsArray),ln=this.localClippingEnabled,Ve=st.init(this.clippingPlanes,ln),Ve===!0&&st.setGlobalState(this.clippingPlanes,k),z!==null&&mt.render(A.state.shadowsArray,Q,k);let Y=new Set;return w.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let At=J.material;if(At)if(Array.isArray(At))for(let Lt=0;Lt<At.length;Lt++){let Tt=At[Lt];ga(Tt,Q,k,J),Y.add(Tt)}else ga(At,Q,k,J),Y.add(At)}),A=E.pop(),z!==null&&z.renderEnd(),Y},this.compileAsync=function(w,k,Q=null){let Y=this.compile(w,k,Q);return new Promise(J=>{function At(){if(Y.forEach(function(Lt){let Dt=Gt.get(Lt).currentProgram;(Dt===void 0||Dt.isReady())&&Y.delete(Lt)}),Y.size===0){J(w);return}setTimeout(At,10)}Kt.get("KHR_parallel_shader_compile")!==null?At():setTimeout(At,10)})};let eo=null;function Bu(w){eo&&eo(w)}function Gl(){bs.stop()}function ns(){bs.start()}let bs=new _0;bs.setAnimationLoop(Bu),typeof self<"u"&&bs.setContext(self),this.setAnimationLoop=function(w){eo=w,ht.setAnimationLoop(w),w===null?bs.stop():bs.start()},ht.addEventListener("sessionstart",Gl),ht.addEventListener("sessionend",ns),this.render=function(w,k){if(k!==void 0&&k.isCamera!==!0){ee("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;z!==null&&z.renderStart(w,k);let Q=ht.enabled===!0&&ht.isPresenting===!0,Y=O!==null&&(lt===null||Q)&&O.begin(I,lt);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ht.enabled===!0&&ht.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(ht.cameraAutoUpdate===!0&&ht.updateCamera(k),k=ht.getCamera()),w.isScene===!0&&w.onBeforeRender(I,w,k,lt),A=nt.get(w,E.length),A.init(k),A.state.textureUnits=qt.getTextureUnits(),E.push(A),Ue.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Je.setFromArrayCamera(k):re.setFromProjectionMatrix(Ue,Li,k.reversedDepth),ln=this.localClippingEnabled,Ve=st.init(this.clippingPlanes,ln),C=vt.get(w,x.length),C.init(),x.push(C),this.info.render.frame++,ht.enabled===!0&&ht.isPresenting===!0){let Lt=I.xr.getDepthSensingMesh();Lt!==null&&ws(Lt,k,-1/0,I.sortObjects)}ws(w,k,0,I.sortObjects),C.finish(),z!==null&&z.updateLights(A.state.lightsArray),I.sortObjects===!0&&C.sort($t,ae),tn=ht.enabled===!1||ht.isPresenting===!1||ht.hasDepthSensing()===!1,tn&&F.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),Ve===!0&&st.beginShadows();let J=A.state.shadowsArray;if(mt.render(J,w,k),Ve===!0&&st.endShadows(),(Y&&O.hasRenderPass())===!1){let Lt=C.opaque,Tt=C.transmissive;if(A.setupLights(),k.isArrayCamera){let Dt=k.cameras;if(Tt.length>0)for(let Vt=0,ie=Dt.length;Vt<ie;Vt++){let me=Dt[Vt];Gi(Lt,Tt,w,me)}tn&&F.render(w);for(let Vt=0,ie=Dt.length;Vt<ie;Vt++){let me=Dt[Vt];_a(C,w,me,me.viewport)}}else Tt.length>0&&Gi(Lt,Tt,w,k),tn&&F.render(w),_a(C,w,k)}lt!==null&&G===0&&(qt.updateMultisampleRenderTarget(lt),qt.updateRenderTargetMipmap(lt)),Y&&O.end(I),w.isScene===!0&&w.onAfterRender(I,w,k),Mt.resetDefaultState(),Z=-1,j=null,E.pop(),E.length>0?(A=E[E.length-1],qt.setTextureUnits(A.state.textureUnits),Ve===!0&&st.setGlobalState(I.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,z!==null&&z.renderEnd()};function ws(w,k,Q,Y){if(w.visible===!1)return;if(w.layers.test(k.layers)){if(w.isGroup)Q=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(k);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Lt=k.isArrayCamera?Je:re;if(!w.frustumCulled||w.intersectsFrustum(Lt)){Y&&be.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ue);let Tt=ut.update(w),Dt=w.material;Dt.visible&&C.push(w,Tt,Dt,Q,be.z,null,k)}}else if(w.isMesh||w.isLine||w.isPoints){let Lt=k.isArrayCamera?Je:re;if(!w.frustumCulled||w.intersectsFrustum(Lt)){let Tt=ut.update(w),Dt=w.material;if(Y&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),be.copy(w.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),be.copy(Tt.boundingSphere.center)),be.applyMatrix4(w.matrixWorld).applyMatrix4(Ue)),Array.isArray(Dt)){let Vt=Tt.groups;for(let ie=0,me=Vt.length;ie<me;ie++){let kt=Vt[ie],ge=Dt[kt.materialIndex];ge&&ge.visible&&C.push(w,Tt,ge,Q,be.z,kt,k)}}else Dt.visible&&C.push(w,Tt,Dt,Q,be.z,null,k)}}}let At=w.children;for(let Lt=0,Tt=At.length;Lt<Tt;Lt++)ws(At[Lt],k,Q,Y)}function _a(w,k,Q,Y){let{opaque:J,transmissive:At,transparent:Lt}=w;A.setupLightsView(Q),Ve===!0&&st.setGlobalState(I.clippingPlanes,Q),Y&&wt.viewport(et.copy(Y)),J.length>0&&en(J,k,Q),At.length>0&&en(At,k,Q),Lt.length>0&&en(Lt,k,Q),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Gi(w,k,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[Y.id]===void 0){let kt=Kt.has("EXT_color_buffer_half_float")||Kt.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[Y.id]=new Mi(1,1,{generateMipmaps:!0,type:kt?Ki:li,minFilter:Bs,samples:Math.max(4,le.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Se.workingColorSpace})}let At=A.state.transmissionRenderTarget[Y.id],Lt=Y.viewport||et;At.setSize(Lt.z*I.transmissionResolutionScale,Lt.w*I.transmissionResolutionScale);let Tt=I.getRenderTarget(),Dt=I.getActiveCubeFace(),Vt=I.getActiveMipmapLevel();I.setRenderTarget(At),I.getClearColor(tt),gt=I.getClearAlpha(),gt<1&&I.setClearColor(16777215,.5),I.clear(),tn&&F.render(Q);let ie=I.toneMapping;I.toneMapping=fs;let me=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),A.setupLightsView(Y),Ve===!0&&st.setGlobalState(I.clippingPlanes,Y),en(w,Q,Y),qt.updateMultisampleRenderTarget(At),qt.updateRenderTargetMipmap(At),Kt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let ge=0,je=k.length;ge<je;ge++){let Le=k[ge],{object:De,geometry:vn,material:Ft,group:hn}=Le;if(Ft.side===Fn&&De.layers.test(Y.layers)){let ve=Ft.side;Ft.side=ni,Ft.needsUpdate=!0,on(De,Q,Y,vn,Ft,hn),Ft.side=ve,Ft.needsUpdate=!0,kt=!0}}kt===!0&&(qt.updateMultisampleRenderTarget(At),qt.updateRenderTargetMipmap(At))}I.setRenderTarget(Tt,Dt,Vt),I.setClearColor(tt,gt),me!==void 0&&(Y.viewport=me),I.toneMapping=ie}function en(w,k,Q){let Y=k.isScene===!0?k.overrideMaterial:null;for(let J=0,At=w.length;J<At;J++){let Lt=w[J],{object:Tt,geometry:Dt,group:Vt}=Lt,ie=Lt.material;ie.allowOverride===!0&&Y!==null&&(ie=Y),Tt.layers.test(Q.layers)&&on(Tt,k,Q,Dt,ie,Vt)}}function on(w,k,Q,Y,J,At){z!==null&&J.isNodeMaterial&&z.setObject(w,J),w.onBeforeRender(I,k,Q,Y,J,At),w.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),J.onBeforeRender(I,k,Q,Y,w,At),J.transparent===!0&&J.side===Fn&&J.forceSinglePass===!1?(J.side=ni,J.needsUpdate=!0,I.renderBufferDirect(Q,k,Y,J,w,At),J.side=fr,J.needsUpdate=!0,I.renderBufferDirect(Q,k,Y,J,w,At),J.side=Fn):I.renderBufferDirect(Q,k,Y,J,w,At),w.onAfterRender(I,k,Q,Y,J,At)}function an(w){let k=0;for(let Q of w)Q.texture!==null&&k++;return k}function is(w,k,Q){k.isScene!==!0&&(k=yn);let Y=Gt.get(w),J=A.state.lights,At=A.state.shadowsArray,Lt=J.state.version,Tt=ot.getParameters(w,J.state,At,k,Q,A.state.lightProbeGridArray),Dt=ot.getProgramCacheKey(Tt),Vt=Y.programs;Y.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?k.environment:null,Y.fog=k.fog;let ie=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;Y.envMap=R.get(w.envMap||Y.environment,ie),Y.envMapRotation=Y.environment!==null&&w.envMap===null?k.environmentRotation:w.envMapRotation,Vt===void 0&&(w.addEventListener("dispose",he),Vt=new Map,Y.programs=Vt,Y.programVariants=new Map);let me=Vt.get(Dt);if(me!==void 0){if(Y.currentProgram===me&&Y.lightsStateVersion===Lt)return xa(w,Tt),me}else Tt.uniforms=ot.getUniforms(w),z!==null&&w.isNodeMaterial&&z.build(w,Q,Tt),w.onBeforeCompile(Tt,I),me=ot.acquireProgram(Tt,Dt),Vt.set(Dt,me),Y.uniforms=Tt.uniforms;let kt=Y.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(kt.clippingPlanes=st.uniform),xa(w,Tt),Y.needsLights=Xs(w),Y.lightsStateVersion=Lt,Y.needsLights&&(kt.ambientLightColor.value=J.state.ambient,kt.lightProbe.value=J.state.probe,kt.sunLights.value=J.state.sun,kt.sunLightShadows.value=J.state.sunShadow,kt.directionalLights.value=J.state.directional,kt.directionalLightShadows.value=J.state.directionalShadow,kt.spotLights.value=J.state.spot,kt.spotLightShadows.value=J.state.spotShadow,kt.rectAreaLights.value=J.state.rectArea,kt.ltc_1.value=J.state.rectAreaLTC1,kt.ltc_2.value=J.state.rectAreaLTC2,kt.pointLights.value=J.state.point,kt.pointLightShadows.value=J.state.pointShadow,kt.hemisphereLights.value=J.state.hemi,kt.sunShadowMatrix.value=J.state.sunShadowMatrix,kt.sunShadowCascade.value=J.state.sunShadowCascade,kt.directionalShadowMatrix.value=J.state.directionalShadowMatrix,kt.spotLightMatrix.value=J.state.spotLightMatrix,kt.spotLightMap.value=J.state.spotLightMap,kt.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=an(A.state.lightProbeGridArray),Y.currentProgram=me,Y.uniformsList=null,me}function di(w,k,Q,Y,J){let At=Gt.get(w),Lt=At.currentProgram.id+","+Y+","+J,Tt=At.programVariants.get(Lt);return Tt===void 0?(Tt=is(w,k,Q),At.programVariants.set(Lt,Tt)):(At.currentProgram=Tt,At.uniformsList=null,At.outputColorSpace=Y,At.toneMapping=J),Tt}function Ws(w){if(w.uniformsList===null){let k=w.currentProgram.getUniforms();w.uniformsList=qo.seqWithValue(k.seq,w.uniforms)}return w.uniformsList}function xa(w,k){let Q=Gt.get(w);Q.outputColorSpace=k.outputColorSpace,Q.batching=k.batching,Q.batchingColor=k.batchingColor,Q.instancing=k.instancing,Q.instancingColor=k.instancingColor,Q.instancingMorph=k.instancingMorph,Q.skinning=k.skinning,Q.morphTargets=k.morphTargets,Q.morphNormals=k.morphNormals,Q.morphColors=k.morphColors,Q.morphTargetsCount=k.morphTargetsCount,Q.numClippingPlanes=k.numClippingPlanes,Q.numIntersection=k.numClipIntersection,Q.vertexAlphas=k.vertexAlphas,Q.vertexTangents=k.vertexTangents,Q.toneMapping=k.toneMapping}function ya(w,k,Q,Y,J){k.isScene!==!0&&(k=yn),qt.resetTextureUnits();let At=k.fog,Lt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?k.environment:null,Tt=lt===null?I.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:Se.workingColorSpace,Dt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Vt=R.get(Y.envMap||Lt,Dt),ie=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,me=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),kt=!!Q.morphAttributes.position,ge=!!Q.morphAttributes.normal,je=!!Q.morphAttributes.color,Le=fs;Y.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Le=I.toneMapping);let De=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=De!==void 0?De.length:0,Ft=Gt.get(Y),hn=A.state.lights;if(Ve===!0&&(ln===!0||w!==j)){let Ne=w===j&&Y.id===Z;st.setState(Y,w,Ne)}let ve=!1,Es=!1;Y.version===Ft.__version?Ft.needsLights&&Ft.lightsStateVersion!==hn.state.version||J.isBatchedMesh&&Ft.batching===!1||!J.isBatchedMesh&&Ft.batching===!0||J.isBatchedMesh&&Ft.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ft.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ft.instancing===!1||!J.isInstancedMesh&&Ft.instancing===!0||J.isSkinnedMesh&&Ft.skinning===!1||!J.isSkinnedMesh&&Ft.skinning===!0||J.isInstancedMesh&&Ft.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ft.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ft.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ft.instancingMorph===!1&&J.morphTexture!==null||Ft.envMap!==Vt||Y.fog===!0&&Ft.fog!==At||Ft.numClippingPlanes!==void 0&&(Ft.numClippingPlanes!==st.numPlanes||Ft.numIntersection!==st.numIntersection)||Ft.vertexAlphas!==ie||Ft.vertexTangents!==me||Ft.morphTargets!==kt||Ft.morphNormals!==ge||Ft.morphColors!==je||Ft.morphTargetsCount!==vn||Ft.numLightProbeGrids!==an(A.state.lightProbeGridArray)?ve=!0:(Ft.outputColorSpace!==Tt||Ft.toneMapping!==Le)&&(Es=!0):(ve=!0,Ft.__version=Y.version);let un=Ft.currentProgram;(ve===!0||Es===!0)&&(un=Es===!0?di(Y,k,J,Tt,Le):is(Y,k,J),z&&Y.isNodeMaterial&&z.onUpdateProgram(Y,un,Ft));let so=!1,ss=!1,As=!1,de=un.getUniforms(),nn=Ft.uniforms;if(wt.useProgram(un.program)&&(so=!0,ss=!0,As=!0),Y.id!==Z&&(Z=Y.id,ss=!0),so||j!==w){wt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),de.setValue(B,"projectionMatrix",w.projectionMatrix),de.setValue(B,"viewMatrix",w.matrixWorldInverse);let dn=de.map.cameraPosition;dn!==void 0&&dn.setValue(B,Rn.setFromMatrixPosition(w.matrixWorld)),le.logarithmicDepthBuffer&&de.setValue(B,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&de.setValue(B,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,ss=!0,As=!0)}if(Ft.needsLights&&(hn.state.sunShadowMap.length>0&&de.setValue(B,"sunShadowMap",hn.state.sunShadowMap,qt),hn.state.directionalShadowMap.length>0&&de.setValue(B,"directionalShadowMap",hn.state.directionalShadowMap,qt),hn.state.spotShadowMap.length>0&&de.setValue(B,"spotShadowMap",hn.state.spotShadowMap,qt),hn.state.pointShadowMap.length>0&&de.setValue(B,"pointShadowMap",hn.state.pointShadowMap,qt)),J.isSkinnedMesh){de.setOptional(B,J,"bindMatrix"),de.setOptional(B,J,"bindMatrixInverse");let Ne=J.skeleton;Ne&&(Ne.boneTexture===null&&Ne.computeBoneTexture(),de.setValue(B,"boneTexture",Ne.boneTexture,qt))}J.isBatchedMesh&&(de.setOptional(B,J,"batchingTexture"),de.setValue(B,"batchingTexture",J._matricesTexture,qt),de.setOptional(B,J,"batchingIdTexture"),de.setValue(B,"batchingIdTexture",J._indirectTexture,qt),de.setOptional(B,J,"batchingColorTexture"),J._colorsTexture!==null&&de.setValue(B,"batchingColorTexture",J._colorsTexture,qt));let Jn=Q.morphAttributes;if((Jn.position!==void 0||Jn.normal!==void 0||Jn.color!==void 0)&&rt.update(J,Q,un),(ss||Ft.receiveShadow!==J.receiveShadow)&&(Ft.receiveShadow=J.receiveShadow,de.setValue(B,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&k.environment!==null&&(nn.envMapIntensity.value=k.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=xA()),ss){if(de.setValue(B,"toneMappingExposure",I.toneMappingExposure),Ft.needsLights&&no(nn,As),At&&Y.fog===!0&&xt.refreshFogUniforms(nn,At),xt.refreshMaterialUniforms(nn,Y,bt,Ct,A.state.transmissionRenderTarget[w.id]),Ft.needsLights&&Ft.numLightProbeGrids>0){let Ne=S,dn=0;for(let Wn of A.state.lightProbeGridArray)Wn.texture!==null&&(Ne.textures[dn]=Wn.texture,Ne.min[dn]=Wn.boundingBox.min,Ne.max[dn]=Wn.boundingBox.max,Ne.resolution[dn]=Wn.resolution,dn++);for(let Wn in Ne)Ne[Wn].length=dn;nn.probesSH.value=Ne.textures,nn.probesMin.value=Ne.min,nn.probesMax.value=Ne.max,nn.probesResolution.value=Ne.resolution}qo.upload(B,Ws(Ft),nn,qt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(qo.upload(B,Ws(Ft),nn,qt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&de.setValue(B,"center",J.center),de.setValue(B,"modelViewMatrix",J.modelViewMatrix),de.setValue(B,"normalMatrix",J.normalMatrix),de.setValue(B,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Ne=Y.uniformsGroups;for(let dn=0,Wn=Ne.length;dn<Wn;dn++){let Hl=Ne[dn];Wt.update(Hl,un),Wt.bind(Hl,un)}}return un}function no(w,k){w.ambientLightColor.needsUpdate=k,w.lightProbe.needsUpdate=k,w.sunLights.needsUpdate=k,w.sunLightShadows.needsUpdate=k,w.directionalLights.needsUpdate=k,w.directionalLightShadows.needsUpdate=k,w.pointLights.needsUpdate=k,w.pointLightShadows.needsUpdate=k,w.spotLights.needsUpdate=k,w.spotLightShadows.needsUpdate=k,w.rectAreaLights.needsUpdate=k,w.hemisphereLights.needsUpdate=k}function Xs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(w,k,Q){let Y=Gt.get(w);Y.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Gt.get(w.texture).__webglTexture=k,Gt.get(w.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,k){let Q=Gt.get(w);Q.__webglFramebuffer=k,Q.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(w,k=0,Q=0){lt=w,$=k,G=Q;let Y=null,J=!1,At=!1;if(w){let Tt=Gt.get(w);if(Tt.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(B.FRAMEBUFFER,Tt.__webglFramebuffer),et.copy(w.viewport),ft.copy(w.scissor),dt=w.scissorTest,wt.viewport(et),wt.scissor(ft),wt.setScissorTest(dt),Z=-1;return}else if(Tt.__webglFramebuffer===void 0)qt.setupRenderTarget(w);else if(Tt.__hasExternalTextures)qt.rebindTextures(w,Gt.get(w.texture).__webglTexture,Gt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let ie=w.depthTexture;if(Tt.__boundDepthTexture!==ie){if(ie!==null&&Gt.has(ie)&&(w.width!==ie.image.width||w.height!==ie.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qt.setupDepthRenderbuffer(w)}}let Dt=w.texture;(Dt.isData3DTexture||Dt.isDataArrayTexture||Dt.isCompressedArrayTexture)&&(At=!0);let Vt=Gt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Vt[k])?Y=Vt[k][Q]:Y=Vt[k],J=!0):w.samples>0&&qt.useMultisampledRTT(w)===!1?Y=Gt.get(w).__webglMultisampledFramebuffer:Array.isArray(Vt)?Y=Vt[Q]:Y=Vt,et.copy(w.viewport),ft.copy(w.scissor),dt=w.scissorTest}else et.copy(Ht).multiplyScalar(bt).floor(),ft.copy(pe).multiplyScalar(bt).floor(),dt=ue;if(Q!==0&&(Y=V),wt.bindFramebuffer(B.FRAMEBUFFER,Y)&&wt.drawBuffers(w,Y),wt.viewport(et),wt.scissor(ft),wt.setScissorTest(dt),J){let Tt=Gt.get(w.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+k,Tt.__webglTexture,Q)}else if(At){let Tt=k;for(let Dt=0;Dt<w.textures.length;Dt++){let Vt=Gt.get(w.textures[Dt]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Dt,Vt.__webglTexture,Q,Tt)}}else if(w!==null&&Q!==0){let Tt=Gt.get(w.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Tt.__webglTexture,Q)}Z=-1};function io(w){let k=Gt.get(w);return(k.__readFormat!==w.format||k.__readType!==w.type)&&(k.__readFormat=w.format,k.__readType=w.type,k.__formatReadable=le.textureFormatReadable(w.format),k.__typeReadable=le.textureTypeReadable(w.type)),k}this.readRenderTargetPixels=function(w,k,Q,Y,J,At,Lt,Tt=0){if(!(w&&w.isWebGLRenderTarget)){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Dt=Gt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt){wt.bindFramebuffer(B.FRAMEBUFFER,Dt);try{let Vt=w.textures[Tt],ie=Vt.format,me=Vt.type;w.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Tt);let kt=io(Vt);if(kt.__formatReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){ee("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=w.width-Y&&Q>=0&&Q<=w.height-J&&B.readPixels(k,Q,Y,J,_t.convert(ie),_t.convert(me),At)}finally{let Vt=lt!==null?Gt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,Vt)}}},this.readRenderTargetPixelsAsync=async function(w,k,Q,Y,J,At,Lt,Tt=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Dt=Gt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Lt!==void 0&&(Dt=Dt[Lt],Array.isArray(Dt)&&(Dt=Dt[0])),Dt)if(k>=0&&k<=w.width-Y&&Q>=0&&Q<=w.height-J){wt.bindFramebuffer(B.FRAMEBUFFER,Dt);let Vt=w.textures[Tt],ie=Vt.format,me=Vt.type;w.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Tt);let kt=io(Vt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ge=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,ge),B.bufferData(B.PIXEL_PACK_BUFFER,At.byteLength,B.STREAM_READ),B.readPixels(k,Q,Y,J,_t.convert(ie),_t.convert(me),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let je=lt!==null?Gt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(B.FRAMEBUFFER,je);let Le=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Xg(B,Le,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,ge),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,At),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(ge),B.deleteSync(Le),At}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,k=null,Q=0){let Y=Math.pow(2,-Q),J=Math.floor(w.image.width*Y),At=Math.floor(w.image.height*Y),Lt=k!==null?k.x:0,Tt=k!==null?k.y:0;qt.setTexture2D(w,0),B.copyTexSubImage2D(B.TEXTURE_2D,Q,0,0,Lt,Tt,J,At),wt.unbindTexture()},this.copyTextureToTexture=function(w,k,Q=null,Y=null,J=0,At=0){let Lt,Tt,Dt,Vt,ie,me,kt,ge,je,Le=w.isCompressedTexture?w.mipmaps[At]:w.image;if(Q!==null)Lt=Q.max.x-Q.min.x,Tt=Q.max.y-Q.min.y,Dt=Q.isBox3?Q.max.z-Q.min.z:1,Vt=Q.min.x,ie=Q.min.y,me=Q.isBox3?Q.min.z:0;else{let de=Math.pow(2,-J);Lt=Math.floor(Le.width*de),Tt=Math.floor(Le.height*de),w.isDataArrayTexture?Dt=Le.depth:w.isData3DTexture?Dt=Math.floor(Le.depth*de):Dt=1,Vt=0,ie=0,me=0}Y!==null?(kt=Y.x,ge=Y.y,je=Y.z):(kt=0,ge=0,je=0);let De=_t.convert(k.format),vn=_t.convert(k.type),Ft;k.isData3DTexture?(qt.setTexture3D(k,0),Ft=B.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(qt.setTexture2DArray(k,0),Ft=B.TEXTURE_2D_ARRAY):(qt.setTexture2D(k,0),Ft=B.TEXTURE_2D),wt.activeTexture(B.TEXTURE0),wt.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,k.flipY),wt.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),wt.pixelStorei(B.UNPACK_ALIGNMENT,k.unpackAlignment);let hn=wt.getParameter(B.UNPACK_ROW_LENGTH),ve=wt.getParameter(B.UNPACK_IMAGE_HEIGHT),Es=wt.getParameter(B.UNPACK_SKIP_PIXELS),un=wt.getParameter(B.UNPACK_SKIP_ROWS),so=wt.getParameter(B.UNPACK_SKIP_IMAGES);wt.pixelStorei(B.UNPACK_ROW_LENGTH,Le.width),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Le.height),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,Vt),wt.pixelStorei(B.UNPACK_SKIP_ROWS,ie),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,me);let ss=w.isDataArrayTexture||w.isData3DTexture,As=k.isDataArrayTexture||k.isData3DTexture;if(w.isDepthTexture){let de=Gt.get(w),nn=Gt.get(k),Jn=Gt.get(de.__renderTarget),Ne=Gt.get(nn.__renderTarget);wt.bindFramebuffer(B.READ_FRAMEBUFFER,Jn.__webglFramebuffer),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ne.__webglFramebuffer);for(let dn=0;dn<Dt;dn++)ss&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Gt.get(w).__webglTexture,J,me+dn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Gt.get(k).__webglTexture,At,je+dn)),B.blitFramebuffer(Vt,ie,Vt+Lt,ie+Tt,kt,ge,kt+Lt,ge+Tt,B.DEPTH_BUFFER_BIT,B.NEAREST);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(J!==0||w.isRenderTargetTexture||Gt.has(w)){let de=Gt.get(w),nn=Gt.get(k);wt.bindFramebuffer(B.READ_FRAMEBUFFER,D),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,H);for(let Jn=0;Jn<Dt;Jn++)ss?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,de.__webglTexture,J,me+Jn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,de.__webglTexture,J),As?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,nn.__webglTexture,At,je+Jn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,nn.__webglTexture,At),J!==0?B.blitFramebuffer(Vt,ie,Vt+Lt,ie+Tt,kt,ge,kt+Lt,ge+Tt,B.COLOR_BUFFER_BIT,B.NEAREST):As?B.copyTexSubImage3D(Ft,At,kt,ge,je+Jn,Vt,ie,Lt,Tt):B.copyTexSubImage2D(Ft,At,kt,ge,Vt,ie,Lt,Tt);wt.bindFramebuffer(B.READ_FRAMEBUFFER,null),wt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else As?w.isDataTexture||w.isData3DTexture?B.texSubImage3D(Ft,At,kt,ge,je,Lt,Tt,Dt,De,vn,Le.data):k.isCompressedArrayTexture?B.compressedTexSubImage3D(Ft,At,kt,ge,je,Lt,Tt,Dt,De,Le.data):B.texSubImage3D(Ft,At,kt,ge,je,Lt,Tt,Dt,De,vn,Le):w.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,At,kt,ge,Lt,Tt,De,vn,Le.data):w.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,At,kt,ge,Le.width,Le.height,De,Le.data):B.texSubImage2D(B.TEXTURE_2D,At,kt,ge,Lt,Tt,De,vn,Le);wt.pixelStorei(B.UNPACK_ROW_LENGTH,hn),wt.pixelStorei(B.UNPACK_IMAGE_HEIGHT,ve),wt.pixelStorei(B.UNPACK_SKIP_PIXELS,Es),wt.pixelStorei(B.UNPACK_SKIP_ROWS,un),wt.pixelStorei(B.UNPACK_SKIP_IMAGES,so),At===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&B.generateMipmap(Ft),wt.unbindTexture()},this.initRenderTarget=function(w){Gt.get(w).__webglFramebuffer===void 0&&qt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?qt.setTextureCube(w,0):w.isData3DTexture?qt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?qt.setTexture2DArray(w,0):qt.setTexture2D(w,0),wt.unbindTexture()},this.resetState=function(){$=0,G=0,lt=null,wt.reset(),Mt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Li}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Se._getDrawingBufferColorSpace(t),e.unpackColorSpace=Se._getUnpackColorSpace()}};var yA=.3,C0=Math.PI/2,R0={cylinder:([n,t])=>new rr(n,n,2*t,40,1,!0).rotateX(C0),sphere:([n])=>new or(n,32,20),ellipsoid:([n,t,e])=>new or(1,32,20).scale(n,t,e),capsule:([n,t])=>new Lr(n,2*t,12,32).rotateX(C0),torus:([n,t])=>new Ja(t,n,16,48)},P0=Object.keys(R0);function I0({shape:n,size:[t,e=0,i=0]}){return n==="cylinder"?Math.hypot(t,e):n==="ellipsoid"?Math.max(t,e,i):n==="sphere"?t:t+e}function L0({shape:n,size:t,center:e,axes:i},{color:s}){let r=new Zi({color:s,transparent:!0,opacity:yA,side:Fn,depthWrite:!1}),o=new Ge(R0[n](t),r),[a,l,c]=i.map(h=>new U(...h));return o.applyMatrix4(new xe().makeBasis(a,l,c).setPosition(...e)),o.userData.hull=!0,o.userData.labelAt=new U(...e),o}function vf(n){let t=n?.meshes;if(!t||!Array.isArray(n.sections))return n;let e=o=>o?.kind==="mesh"&&Object.hasOwn(t,o.mesh)?{...o,mesh:t[o.mesh]}:o,i=o=>Array.isArray(o?.items)?{...o,items:o.items.map(e)}:o,s=o=>o?.type==="row"&&Array.isArray(o.blocks)?{...o,blocks:o.blocks.map(s)}:o?.type!=="scene"||!Array.isArray(o.layers)?o:{...o,layers:o.layers.map(i)},r=o=>Array.isArray(o?.blocks)?{...o,blocks:o.blocks.map(s)}:o;return{...n,sections:n.sections.map(r)}}var ci=Array.isArray,wn=n=>t=>ci(t)&&t.length===n,Sl=Number.isFinite,qe=n=>typeof n=="string",Fe=n=>t=>ci(t)&&t.every(n),En=n=>t=>t!==null&&typeof t=="object"&&Object.entries(n).every(([e,i])=>i(t[e])),vA=En({vertices:qe,triangles:qe,origin:wn(3),step:Sl}),Sf={segment:{a:wn(3),b:wn(3)},axis:{point:wn(3),direction:wn(3)},arrow:{from:wn(3),vector:wn(3)},hull:{vertices:Fe(wn(3)),faces:Fe(wn(3))},points:{positions:Fe(wn(3))},line:{positions:Fe(wn(3))},lines:{positions:n=>Fe(wn(3))(n)&&n.length%2===0},surface:{shape:n=>P0.includes(n),size:ci,center:wn(3),axes:n=>wn(3)(n)&&n.every(wn(3))},mesh:{mesh:vA},cone:{tip:wn(3),axis:wn(3),radius:Sl}},SA=n=>n===void 0||/^#[0-9a-f]{6}$/i.test(n),MA=n=>n&&n.kind in Sf&&En(Sf[n.kind])(n)&&SA(n.color),bA=n=>n.x.length===n.y.length&&[n.band_low,n.band_high,n.labels,n.hints].every(t=>!t||t.length===n.x.length),wA=n=>En({name:qe,x:ci,y:ci})(n)&&bA(n),EA=En({group:qe,measured:wn(2),predicted:wn(2)}),AA=En({name:qe,panels:Fe(En({title:qe,arrows:Fe(EA)}))}),N0=(n,t)=>ci(n)&&n.every(e=>e?.length===t),TA=(n,{chains:t,draws:e})=>n.every(i=>[i.traces,i.ranks.counts,i.autocorrelation].every(s=>s?.length===t?.length)&&N0(i.traces,e?.length)),CA=En({counts:Fe(ci),mean:Sl,low:Sl,high:Sl}),RA=En({name:qe,traces:ci,ranks:CA,autocorrelation:ci}),PA=n=>En({name:qe,draws:ci})(n)&&n.draws.length>2,IA=n=>N0(n.map(t=>t.draws),n[0]?.draws.length??0),LA=(n,{quantities:t})=>n===void 0||ci(n)&&n.every(e=>e in(t??[])),DA=n=>En({name:qe,values:Fe(En({}))})(n),NA=(n,{components:t})=>n.every(e=>e.rows.every(i=>i.values.length===t?.length)),Mf={table:{columns:[Fe(En({name:qe})),"a list of {name}"],rows:[Fe(ci),"a list of lists"]},lines:{series:[Fe(wA),"a list of {name, x, y}, all of one length"]},vectors:{planes:[Fe(AA),"a list of {name, panels: [{title, arrows: [{group, measured: [2], predicted: [2]}]}]}"]},scene:{layers:[Fe(En({name:qe,items:Fe(MA)})),`a list of {name, items}, items of kind ${Object.keys(Sf).join(", ")} with coordinates`],color_scale:[n=>n===void 0||qe(n?.label)&&[n.low,n.high].every(Number.isFinite),"{label, low, high}"],strip:[n=>n===void 0||Fe(Number.isFinite)(n),"a list of times"]},bars:{groups:[Fe(En({name:qe,values:Fe(En({series:qe}))})),"a list of {name, values: [{series, value}]}"]},interval:{rows:[Fe(En({name:qe})),"a list of {name, estimate, low, high}"]},banner:{ok:[n=>typeof n=="boolean","true or false"],caution:[n=>n===void 0||typeof n=="boolean","true or false"],title:[qe,"a string"],reasons:[n=>n===void 0||Fe(qe)(n),"a list of strings"]},chains:{chains:[Fe(qe),"a list of names"],draws:[ci,"a list of numbers"],quantities:[(n,t)=>Fe(RA)(n)&&TA(n,t),"a list of {name, traces, ranks: {counts, mean, low, high}, autocorrelation}, a list in each for each chain"]},corner:{quantities:[n=>Fe(PA)(n)&&IA(n),"a list of {name, draws}, equally many draws, at least 3"],shown:[LA,"a list of indices of quantities"]},predictive:{components:[Fe(qe),"a list of names"],groups:[(n,t)=>Fe(En({name:qe,rows:Fe(DA)}))(n)&&NA(n,t),"a list of {name, rows: [{name, values}]}, a value for each component"]},text:{text:[qe,"a string"]},row:{blocks:[ci,"a list of blocks"]}},UA={lines:"series",vectors:"planes",scene:"layers",bars:"groups",interval:"rows",chains:"quantities",corner:"quantities",predictive:"groups"},U0=n=>n[UA[n.type]]?.length===0,OA=Object.keys(Mf);function FA(n){let t=n.rows.findIndex(e=>e.length!==n.columns.length);return t<0?[]:[`table: row ${t} has ${n.rows[t].length} cells, wanted ${n.columns.length}`]}function O0(n){if(!n||!(n.type in Mf))return[`unknown block type "${n?.type}"; known are ${OA.join(", ")}`];let t=Object.entries(Mf[n.type]).filter(([e,[i]])=>!i(n[e],n)).map(([e,[,i]])=>`${n.type}: "${e}" must be ${i}`);return n.type==="table"&&!t.length?FA(n):t}var BA=n=>n===void 0||n!==null&&typeof n=="object"&&["asked","done","learnt"].every(t=>qe(n[t])),D0=n=>t=>t===void 0||n(t),yN={opening:[BA,"{asked, done, learnt}"],summary:[D0(Fe(En({text:qe}))),"a list of {text}"],pages:[D0(Fe(En({file:qe,title:qe}))),"a list of {file, title}"]};var zA={true:"\u2713",false:"\u26A0"},F0=8,B0=n=>q("ul",{},...n.map(t=>q("li",{},t)));function kA(n){if(!n.length)return[];let t=n.slice(F0);return[B0(n.slice(0,F0)),t.length?q("details",{},q("summary",{},`${t.length} more reasons`),B0(t)):null]}var VA=(n,t)=>t?"caution":n?"good":"bad",z0=({ok:n,caution:t=!1,title:e,text:i,reasons:s=[]})=>q("div",{class:`banner ${VA(n,t)}`,role:n||t?"status":"alert"},q("p",{class:"banner-title"},q("span",{"aria-hidden":"true"},zA[n&&!t]),e),...kA(s),i?q("p",{},i):null);function ms(n,t){let e=q("div",n),i=0;e.redraw=()=>i&&e.replaceChildren(...t(i));let s=()=>{let r=Math.floor(e.clientWidth);!r||r===i||(i=r,e.redraw())};return new ResizeObserver(s).observe(e),addEventListener("beforeprint",s),e}var bf={width:26,height:4};function Kh({color:n="var(--ink)",mark:t="box",dash:e}){if(t!=="line")return q("span",{class:`swatch ${t}`,style:`--swatch: ${n}`});let i=bf.height/2;return ct("svg",{class:"swatch-line",...bf,"aria-hidden":"true"},ct("line",{x1:0,x2:bf.width,y1:i,y2:i,style:`stroke: ${n}`,"stroke-width":3,"stroke-dasharray":e?.join(" ")}))}function GA({name:n,...t},e){let i=q("button",{type:"button","aria-pressed":"true",title:`Hide or show ${n}`},Kh(t),n);return i.addEventListener("click",()=>{let s=i.getAttribute("aria-pressed")!=="true";i.setAttribute("aria-pressed",String(s)),e(n,s)}),i}var gr=(n,t)=>q("div",{class:"legend",role:"group","aria-label":"Legend"},...n.map(e=>GA(e,t))),_r=n=>q("div",{class:"legend key"},...n.map(({name:t,...e})=>q("span",{},Kh(e),t)));var Xt=n=>typeof n=="number"&&Number.isFinite(n),V0=n=>n.replace(/-/g,"\u2212"),wf=n=>n.replace(/(\.\d*?)0+(?=e|$)/,"$1").replace(/\.(?=e|$)/,"").replace("e+","e");function HA(n,t){let e=Math.abs(n);return e!==0&&(e<.001||e>=1e6)?wf(n.toExponential(t-1)):wf(n.toPrecision(t).includes("e")?n.toFixed(0):n.toPrecision(t))}function WA(n,t){let e=n.toFixed(t);return Number(e)===0&&n!==0?wf(n.toExponential(1)):e}var XA=1e-12,$A=1e-6;function YA(n,t,e){let i=t==null?0:$A*10**-t;return Math.abs(n)<Math.max(i,XA*e)}function Ot(n,t,e=0){if(!Xt(n))return"n/a";let i=YA(n,t,e)?0:n;return V0(t==null?HA(i,4):WA(i,t))}var Vr=n=>n.reduce((t,e)=>Xt(e)?Math.max(t,Math.abs(e)):t,0);function G0(n,t,e){return n==null?"n/a":typeof n=="boolean"?n?"yes":"no":typeof n=="number"?Ot(n,t,e):String(n)}var k0=12;function qA(n,t){for(let e=0;e<k0;++e)if(n.every(i=>Math.abs(i-Number(i.toFixed(e)))<1e-6*t))return e;return k0}function gs(n){let t=Vr(n),e=n.slice(1).map((l,c)=>Math.abs(l-n[c])),i=Math.min(...e.filter(l=>l>0),t||1),s=t!==0&&(t<.001||t>=1e6)?Math.floor(Math.log10(t)):0,r=n.map(l=>Math.abs(l)<1e-6*i?0:l/10**s),o=qA(r,i/10**s),a=l=>s&&l!==0?`e${s}`:"";return r.map(l=>V0(`${l.toFixed(l===0&&s?0:o)}${a(l)}`))}var Ml=["blue","vermillion","green","purple","orange","sky","ink","indigo","brown","wine"],ZA={blue:"#0072b2",vermillion:"#d55e00",green:"#009e73",purple:"#cc79a7",orange:"#e69f00",sky:"#56b4e9",ink:"#777777",indigo:"#222288",brown:"#664433",wine:"#993366"},H0=[void 0,[8,4],[2,3],[10,3,2,3]],hi=n=>`var(--${Ml[n%Ml.length]})`,Jo=n=>H0[Math.floor(n/Ml.length)%H0.length];function _s(n){let t=bl(n.filter(({faint:e})=>!e).map(({name:e})=>e));return n.map(({name:e,faint:i})=>i?{color:"var(--muted)",dash:void 0}:{color:hi(t.get(e)),dash:Jo(t.get(e))})}var W0=n=>ZA[Ml[n%Ml.length]];function bl(n){let t=new Map;for(let e of n)t.has(e)||t.set(e,t.size);return t}function wl(n){let t=10**Math.floor(Math.log10(n));return[1,2,5,10].find(i=>i*t>=n*(1-1e-9))*t}function si(n,t,e=5){if(!(t>n))return[n];let i=wl((t-n)/e),s=[];for(let r=Math.ceil(n/i-1e-9);r*i<=t+1e-9*i;++r)s.push(Number((r*i).toPrecision(12)));return s}var JA=1e-12;function Ei(n,t=0,e=JA){let i=n.filter(Number.isFinite);if(i.length===0)return[0,1];let s=i.reduce((l,c)=>Math.min(l,c)),r=i.reduce((l,c)=>Math.max(l,c)),o=Math.max(Math.abs(s),Math.abs(r)),a=r-s>e*o?t*(r-s):.5*(o||1);return[s-a,r+a]}var gn=([n,t],[e,i])=>s=>e+(s-n)/(t-n)*(i-e);var xs=null;function KA(n){let e=xs.offsetWidth,i=xs.offsetHeight,s=n.clientX+14+e>innerWidth?n.clientX-14-e:n.clientX+14,r=n.clientY+14+i>innerHeight?n.clientY-14-i:n.clientY+14;xs.style.left=`${Math.max(0,s)}px`,xs.style.top=`${Math.max(0,r)}px`}function Vs(n,t){xs??(xs=document.body.appendChild(q("div",{class:"tooltip",role:"status"}))),xs.replaceChildren(...t.map((e,i)=>q(i===0?"strong":"div",{},e))),xs.hidden=!1,KA(n)}var jh=(n,t,e,i=!1)=>q("span",{class:i?"reading near":"reading"},Kh({...n,mark:"line"}),q("span",{},t),q("span",{class:"value"},e));function Oi(){xs&&(xs.hidden=!0)}function Fi(n,t){return n.setAttribute("aria-label",t.join(", ")),n.addEventListener("pointermove",e=>Vs(e,t)),n.addEventListener("pointerleave",Oi),n}var Gr=n=>6.7*String(n).length;function Ko(n,t,e,i,s,r){let o=gs(t);return[...t.flatMap((a,l)=>[ct("line",{class:a===0?"zero":"grid",x1:n(a),x2:n(a),y1:e,y2:i}),ct("text",{x:n(a),y:i+15,"text-anchor":"middle"},o[l])]),ct("text",{class:"label",x:r,y:i+34,"text-anchor":"middle"},s??"")]}var Qh=(n,t,e,i)=>t.flatMap(({label:s,value:r})=>[ct("line",{class:"reference",x1:n(r),x2:n(r),y1:e,y2:i}),ct("text",{class:"label",x:n(r),y:e-6,"text-anchor":"middle"},s??"")]);var Hr=15,QA=12,Af=18,X0=520,Tf=56,Ef=26,$0=42;function tT(n){let t=n.groups.flatMap(s=>s.values.flatMap(r=>[r.value,r.low,r.high])),[e,i]=Ei([0,...t.filter(Xt),...(n.reference_lines??[]).map(s=>s.value)],.06);return[t.some(s=>s<0)?e:0,i]}function eT(n,t,e,i,s,r){let o=f=>Ot(f,void 0,r),a=Xt(n.value),l=e(a?n.value:0),c=Math.max(e(0),l,Xt(n.high)?e(n.high):0),h=Xt(n.low)&&Xt(n.high)?[ct("line",{class:"whisker",x1:e(n.low),x2:e(n.high),y1:i+Hr/2,y2:i+Hr/2})]:[],u=ct("g",{class:"bar","data-group":n.series,style:`color: ${s}`,role:"img"},ct("rect",{x:Math.min(e(0),l),y:i+1,width:Math.abs(l-e(0)),height:Hr-2}),...h,ct("text",{x:c+5,y:i+Hr-4},a?o(n.value):"n/a")),d=h.length?[`interval ${o(n.low)} to ${o(n.high)}`]:[];return Fi(u,[`${t}, ${n.series}`,o(n.value),...d])}function nT(n,t){let e=14+Math.max(60,...n.groups.map(l=>Gr(l.name))),i=t<X0||t-e<X0/2,s=i?12:e,r=tT(n),o=gn(r,[s,t-Tf]),a=Math.min(6,Math.max(2,Math.floor((t-Tf-s)/70)));return{x:o,range:r,left:s,narrow:i,width:t,count:a}}function iT(n,t,{x:e,left:i,narrow:s},r,o){let a=t+n.values.length*Hr/2+4,l=s?{x:i,y:t+Af-5}:{x:i-8,y:a,"text-anchor":"end"},c=t+(s?Af:0);return[ct("text",{class:"name",...l},n.name),...n.values.map((h,u)=>eT(h,n.name,e,c+u*Hr,r(h.series),o))]}function sT(n,t,e,i){let s=nT(n,i),{x:r,range:o,left:a,count:l}=s,c=Vr(n.groups.flatMap(d=>d.values.map(f=>f.value))),h=Ef,u=n.groups.flatMap(d=>{let f=iT(d,h,s,m=>hi(t.get(m)),c);return h+=(s.narrow?Af:0)+d.values.length*Hr+QA,f});return u.filter(d=>e.has(d.dataset.group)).forEach(d=>d.style.display="none"),ct("svg",{class:"plot",width:i,height:h+$0,viewBox:`0 0 ${i} ${h+$0}`,role:"group","aria-label":n.caption??"Bars"},...Ko(r,si(...o,l),Ef-4,h,n.x_label,(a+i-Tf)/2),...u,...Qh(r,n.reference_lines??[],Ef-4,h))}function Y0(n){let t=n.groups.flatMap(a=>a.values.map(l=>l.series)),e=bl(t),i=new Set,s=ms({class:"chart"},a=>[sT(n,e,i,a)]),r=(a,l)=>{l?i.delete(a):i.add(a),s.redraw()},o=[...e].map(([a,l])=>({name:a,color:hi(l)}));return pn("figure",n.caption,o.length>1?gr(o,r):null,s)}var q0={x:70,y:36},Z0=(n,t,e,i,s)=>ct("line",{class:n,x1:t,y1:e,x2:i,y2:s});function jo(n,t,e,i,s){let r=n-e.right,o=t-e.bottom;return{width:n,height:t,left:e.left,top:e.top,right:r,bottom:o,x:gn(i,[e.left,r]),y:gn(s,[o,e.top]),xs:i,ys:s}}function Cf(n,{x_label:t,y_label:e}){let{left:i,right:s,top:r,bottom:o,x:a,y:l,xs:c,ys:h}=n,u=(_,g)=>Math.max(2,Math.floor(_/g)),d=si(...c,u(s-i,q0.x)),f=si(...h,u(o-r,q0.y)),m=[gs(d),gs(f)];return[...d.flatMap((_,g)=>[Z0("grid",a(_),r,a(_),o),ct("text",{x:a(_),y:o+14,"text-anchor":"middle"},m[0][g])]),...f.flatMap((_,g)=>[Z0("grid",i,l(_),s,l(_)),ct("text",{x:i-5,y:l(_)+4,"text-anchor":"end"},m[1][g])]),ct("text",{class:"label",x:(i+s)/2,y:o+30,"text-anchor":"middle"},t??""),ct("text",{class:"label","text-anchor":"middle",transform:`translate(12 ${(r+o)/2}) rotate(-90)`},e??"")]}var Wr=(n,t,...e)=>ct("svg",{class:"plot panel",width:n.width,height:n.height,viewBox:`0 0 ${n.width} ${n.height}`,role:"img","aria-label":t},...e);function xr(n){let t="M";return n.map(([e,i])=>{if(!Number.isFinite(e)||!Number.isFinite(i))return t="M","";let s=`${t}${e.toFixed(1)} ${i.toFixed(1)}`;return t="L",s}).join("")}function J0(n,t,e,i){let s=null;return n.forEach((r,o)=>{if(t[o])for(let a of r){if(a.y===null)continue;let l=e(a);(!s||l<s.d)&&(s={...a,s:o,d:l})}}),s&&s.d<i?s:null}var rT=({style:n="lines"})=>n!=="points";function K0(n,t,e){let i=t.flatMap((s,r)=>e[r]&&rT(n.series[r])?s.filter(({y:o})=>o!==null).map(({x:o})=>o):[]);return[...new Set(i)].sort((s,r)=>s-r)}function tu(n,t){let e=0,i=n.length-1;for(;i-e>1;){let s=e+i>>1;n[s]<=t?e=s:i=s}return Math.abs(n[i]-t)<Math.abs(n[e]-t)?n[i]:n[e]}function Rf(n,t,e){return n.flatMap((i,s)=>t[s]?i.filter(r=>r.x===e&&r.y!==null).map(r=>({...r,s})):[]).sort((i,s)=>s.y-i.y)}var Pf=230,Xr={left:62,right:10,top:10,bottom:40},oT=44,Qo=({name:n,unit:t})=>t?`${n} [${t}]`:n;function j0(n,t,e,i,s,r,o){let a=l=>{let c=(i[0]??[]).map(({x:_})=>_),u=gn([t.left,t.right],t.xs)(l.clientX-n.getBoundingClientRect().left),d=c.indexOf(tu(c,u)),m=i.map((_,g)=>s[g]&&_[d]?jh({color:hi(g),dash:Jo(g)},e.chains[g],o(_[d].y)):null).filter(Boolean);m.length?Vs(l,[r(c[d]),...m]):Oi()};return n.addEventListener("pointermove",a),n.addEventListener("pointerleave",Oi),n}function If(n,t,e){return t.map((i,s)=>e[s]?ct("path",{class:"trace",style:`color: ${hi(s)}`,"stroke-dasharray":Jo(s)?.join(" "),d:xr(i.map(r=>[n.x(r.x),n.y(r.y??NaN)]))}):null)}var Q0=(n,t)=>n.map(e=>e.map((i,s)=>({x:t[s],y:i??NaN})));function t_(n,t,e,i){let s=Q0(t.traces,n.draws),r=Ei(s.flatMap(u=>u.map(d=>d.y)),.05),o=jo(i,Pf,Xr,[1,n.draws.at(-1)],r),a=n.draws.length>1?n.draws[1]-n.draws[0]:1,l=Cf(o,{x_label:`draw after warm-up${a>1?`, one in ${a} shown`:""}`,y_label:Qo({name:"value",unit:t.unit})}),c=Wr(o,`Trace of ${Qo(t)}, ${s.length} chains`,...l,...If(o,s,e));return j0(c,o,n,s,e,u=>`draw ${u}`,u=>`${Ot(u)} ${t.unit??""}`)}function e_(n,t,e,i){let s=t.lag_step,r=t.autocorrelation.map(h=>h.map((u,d)=>({x:d*s,y:u??NaN}))),o=Math.min(-.2,...r.flat().map(h=>Xt(h.y)?h.y:0)),a=Math.max(1,...r.map(h=>(h.length-1)*s)),l=jo(i,Pf-30,Xr,[0,a],[o,1]),c=Wr(l,`Autocorrelation of ${Qo(t)}`,...Cf(l,{x_label:"lag [draws]",y_label:"autocorrelation"}),ct("line",{class:"zero",x1:l.left,x2:l.right,y1:l.y(0),y2:l.y(0)}),...If(l,r,e));return j0(c,l,n,r,e,h=>`lag ${h}`,h=>Ot(h))}function aT(n,{counts:t,mean:e,low:i,high:s},r,o,{x:a,y:l,bottom:c}){let h=t[r][o],u=100/t[r].length,d=ct("rect",{class:h<i||h>s?"rank out":"rank",x:a(o)+.5,width:Math.max(.5,a(o+1)-a(o)-1),y:l(h),height:Math.max(0,c-l(h))});return Fi(d,[`${n.chains[r]}, ranks ${Ot(o*u)} to ${Ot((o+1)*u)} %`,`${Ot(h)} draws, expected ${Ot(e)}`,`95 % of counts lie within ${Ot(i)} to ${Ot(s)}`])}function n_(n,t,e,i){let{ranks:s}=t,r=s.counts.map((f,m)=>m).filter(f=>e[f]),o=Math.max(oT,(Pf-50)/Math.max(1,r.length)),a=Xr.top+o*r.length+Xr.bottom,l=s.counts[0]?.length??1,c=Math.max(s.high,...s.counts.flat())*1.05||1,h=jo(i,a,Xr,[0,100],[0,1]),u=r.flatMap((f,m)=>{let _=Xr.top+(m+1)*o,g={...Xr,top:_-o+4,bottom:a-_},p=jo(i,a,g,[0,l],[0,c]),v=T=>({x1:p.left,x2:p.right,y1:p.y(T),y2:p.y(T)});return[ct("rect",{class:"rank-band",x:p.left,width:p.right-p.left,y:p.y(s.high),height:p.y(s.low)-p.y(s.high)}),ct("g",{style:`color: ${hi(f)}`},...s.counts[f].map((T,S)=>aT(n,s,f,S,p))),ct("line",{class:"reference",...v(s.mean)}),ct("line",{class:"zero",...v(0)}),ct("text",{x:p.left-5,y:_-4,"text-anchor":"end"},n.chains[f])]}),d=[0,50,100].map(f=>ct("text",{x:h.x(f),y:h.bottom+14,"text-anchor":f===100?"end":"middle"},Ot(f)));return Wr(h,`Rank histograms of ${Qo(t)}`,...u,...d,ct("text",{class:"label",x:(h.left+h.right)/2,y:h.bottom+30,"text-anchor":"middle"},"rank among all draws [%]"))}function i_(n,t,e,i){let s=Q0(t.traces,n.draws),r=Ei(s.flatMap(c=>c.map(h=>h.y)),.05),a=jo(e,i,{left:1,right:1,top:2,bottom:2},[1,n.draws.at(-1)],r),l=Wr(a,`Trace of ${t.name}`,...If(a,s,s.map(()=>!0)));return l.setAttribute("preserveAspectRatio","none"),l}var lT=6,cT=1.01,Lf=({r_hat:n})=>!Xt(n)||n>cT,Df=({r_hat:n})=>Xt(n)?n.toFixed(3):"n/a";function hT(n){let t=e=>Xt(e)?Ot(Math.round(e)):"n/a";return q("span",{class:`facts ${Lf(n)?"bad":""}`},`R-hat ${Df(n)}, bulk ESS ${t(n.bulk_ess)}, tail ESS ${t(n.tail_ess)}`)}function uT(n,t){let e=q("select",{"aria-label":"Quantity",onchange:()=>t(Number(e.value))},...n.map((r,o)=>q("option",{value:o},`${Lf(r)?"\u26A0 ":""}${Qo(r)} (${Df(r)})`))),i=(r,o,a)=>q("button",{type:"button","aria-label":a,title:a,onclick:()=>t((Number(e.value)+r+n.length)%n.length)},o),s=[i(-1,"\u2039","Previous quantity"),i(1,"\u203A","Next quantity")];return{select:e,buttons:n.length>1?s:[]}}function dT(n,t){let i=n.quantities.slice(0,lT).map((s,r)=>q("button",{type:"button",class:"thumbnail",onclick:()=>t(r)},q("span",{class:"thumbnail-name"},...$l(s.name)),q("span",{class:`facts ${Lf(s)?"bad":""}`},`R-hat ${Df(s)}`),i_(n,s,150,46)));return{buttons:i,frame:q("div",{class:"gallery"},...i)}}function s_(n){let{quantities:t}=n,e=n.chains.map(()=>!0),i=0,s=q("span",{"aria-live":"polite"}),r=[t_,n_,e_].map(m=>ms({class:"chain-panel"},_=>[m(n,t[i],e,_)])),o=m=>{i=m,a.value=String(m),s.replaceChildren(hT(t[m])),c.buttons.forEach((_,g)=>_.setAttribute("aria-pressed",String(g===m))),r.forEach(_=>_.redraw())},{select:a,buttons:l}=uT(t,o),c=dT(n,o);o(0);let[h,u,d]=r,f=t.length>1?q("div",{class:"chain-panel"},q("h3",{},"Largest R-hat first"),c.frame):null;return pn("figure",n.caption,q("div",{class:"tools chooser"},a,...l,s),gr(n.chains.map((m,_)=>({name:m,color:hi(_),dash:Jo(_),mark:"line"})),(m,_)=>{e[n.chains.indexOf(m)]=_,r.forEach(g=>g.redraw())}),q("div",{class:"chain-panels"},h,u,d,f))}var fT={1:[[0,3]],2:[[1,0]],3:[[1,3]],4:[[2,1]],5:[[0,3],[2,1]],6:[[2,0]],7:[[2,3]],8:[[3,2]],9:[[0,2]],10:[[1,0],[3,2]],11:[[1,2]],12:[[3,1]],13:[[0,1]],14:[[3,0]]},Nf=[[0,0],[1,0],[1,1],[0,1]],pT=[[0,1],[1,2],[3,2],[0,3]],Uf=({cells:n,side:t},e,i)=>e<0||i<0||e>=t||i>=t?0:n[i*t+e];function r_(n,t,e,i,s){let[r,o]=pT[s].map(h=>[e+Nf[h][0],i+Nf[h][1]]),[a,l]=[Uf(n,...r),Uf(n,...o)],c=(t-a)/(l-a);return{name:`${r}:${o}`,point:[0,1].map(h=>n.low[h]+n.step[h]*(r[h]+c*(o[h]-r[h])))}}function mT(n,t){let e=new Map;for(let i=-1;i<n.side;++i)for(let s=-1;s<n.side;++s){let r=Nf.reduce((o,[a,l],c)=>o|(Uf(n,s+a,i+l)>=t?1<<c:0),0);for(let[o,a]of fT[r]??[]){let l=r_(n,t,s,i,o);e.set(l.name,{point:l.point,to:r_(n,t,s,i,a).name})}}return e}function o_(n,t){let e=mT(n,t),i=[];for(;e.size;){let s=[],[r]=e.keys();for(;e.has(r);){let{point:o,to:a}=e.get(r);e.delete(r),s.push(o),r=a}i.push(s)}return i}var h_=128,Bi=56,El=n=>n.reduce((t,e)=>t+e,0)/n.length,$r=n=>{let t=El(n),e=n.reduce((i,s)=>i+(s-t)**2,0);return Math.sqrt(e/Math.max(1,n.length-1))};function u_(n,t,e,i){let s=new Float64Array(i);for(let r of n){let o=Math.floor((r-t)/(e-t)*i);s[Math.min(i-1,Math.max(0,o))]+=1/n.length}return s}function gT(n){let t=n.length,e=[];for(let i=1;i<t;++i){let s=0;for(let r=0;r<t;++r)s+=n[r]*Math.cos(Math.PI*i*(r+.5)/t);e.push(s**2)}return e}function a_(n,t,e){let i=0;return n.forEach((s,r)=>{let o=(r+1)**2;i+=o**t*s*Math.exp(-o*Math.PI**2*e)}),2*Math.PI**(2*t)*i}var l_=7;function Of(n,t,e){let i=a_(n,l_,e);for(let s=l_-1;s>=2;--s){let r=1;for(let a=3;a<2*s;a+=2)r*=a;let o=(1+.5**(s+.5))/3*(r/Math.sqrt(2*Math.PI));i=a_(n,s,(2*o/(t*i))**(2/(3+2*s)))}return e-(2*t*Math.sqrt(Math.PI)*i)**(-2/5)}function d_(n){let t=Math.min(...n),i=Math.max(...n)-t;if(!(i>0))return 0;let s=t-.1*i,r=1.2*i,o=gT(u_(n,s,s+r,h_)),[a,l]=[1e-9,.1],c=.9*$r(n)*n.length**-.2;if(!(Of(o,n.length,a)<0&&Of(o,n.length,l)>0))return c;for(let h=0;h<40;++h){let u=Math.sqrt(a*l);Of(o,n.length,u)<0?a=u:l=u}return Math.min(2*c,Math.sqrt(a)*r)}function Ff(n,t){let e=Math.max(1,Math.ceil(4*n/t)),i=Array.from({length:2*e+1},(r,o)=>Math.exp(-.5*((o-e)*t/Math.max(n,.3*t))**2)),s=i.reduce((r,o)=>r+o,0);return{reach:e,weights:i.map(r=>r/s)}}function Bf(n,t,e,{reach:i,weights:s}){let r=new Float64Array(e);for(let o=0;o<e;++o){let a=n[t(o)];if(a!==0)for(let l=-i;l<=i;++l)o+l>=0&&o+l<e&&(r[o+l]+=a*s[l+i])}for(let o=0;o<e;++o)n[t(o)]=r[o]}function zf(n){let t=d_(n);if(!(t>0))return{x:[],y:[]};let e=Math.min(...n)-3*t,i=Math.max(...n)+3*t,s=Math.min(512,Math.max(h_,Math.ceil(3*(i-e)/t))),r=(i-e)/s,o=u_(n,e,i,s);return Bf(o,a=>a,s,Ff(t,r)),{x:Array.from(o,(a,l)=>e+(l+.5)*r),y:Array.from(o,a=>a/r)}}function _T(n,t){let[e,i]=[El(n),El(t)],s=$r(n),o=n.reduce((l,c,h)=>l+(c-e)*(t[h]-i),0)/(n.length-1)/s,a=Math.sqrt(Math.max($r(t)**2-o**2,0));return{usable:s>0&&a>0,into:(l,c)=>{let h=(l-e)/s;return[h,(c-i-o*h)/a]},back:([l,c])=>[e+s*l,i+o*l+a*c]}}var c_=(n,t)=>[Math.min(...n)-4*t,Math.max(...n)+4*t];function xT(n,t){let e=n.length**.033333333333333354,[i,s]=[n,t].map(m=>e*d_(m)),[r,o]=c_(n,i),[a,l]=c_(t,s),[c,h]=[(o-r)/Bi,(l-a)/Bi],u=new Float64Array(Bi*Bi);n.forEach((m,_)=>{let g=Math.floor((m-r)/c),p=Math.floor((t[_]-a)/h);u[p*Bi+g]+=1});let d=Ff(i,c),f=Ff(s,h);for(let m=0;m<Bi;++m)Bf(u,_=>m*Bi+_,Bi,d);for(let m=0;m<Bi;++m)Bf(u,_=>_*Bi+m,Bi,f);return{cells:u,side:Bi,low:[r+c/2,a+h/2],step:[c,h]}}function yT({cells:n,side:t,low:e,step:i},s,r){let o=Math.min(t-1,Math.max(0,Math.round((s-e[0])/i[0]))),a=Math.min(t-1,Math.max(0,Math.round((r-e[1])/i[1])));return n[a*t+o]}function kf(n,t,e){let i=_T(n,t),s=n.map((u,d)=>[u,t[d]]);if(!i.usable)return{rings:e.map(()=>[]),outside:s};let r=s.map(([u,d])=>i.into(u,d)),o=xT(r.map(([u])=>u),r.map(([,u])=>u)),a=r.map(([u,d])=>yT(o,u,d)),l=[...a].sort((u,d)=>d-u),c=e.map(u=>l[Math.min(n.length-1,Math.floor(u*n.length))]),h=Math.min(...c);return{rings:c.map(u=>o_(o,u).map(d=>d.map(i.back))),outside:s.filter((u,d)=>a[d]<h)}}function f_(n,t){let[e,i]=[El(n),El(t)];return n.reduce((r,o,a)=>r+(o-e)*(t[a]-i),0)/((n.length-1)*$r(n)*$r(t))}var nu=7,eu=18,vT=74,ST=[.9,.5];function MT({draws:n,prior:t=[],truth:e}){let i=Math.min(...n),s=Math.max(...n),r=s-i||Math.abs(i)||1,o=[...t].sort((c,h)=>c-h),a=c=>o[Math.floor(c*(o.length-1))],l=[i-.06*r,s+.06*r];return o.length&&(l[0]=Math.min(l[0],Math.max(a(.05),i-.5*r)),l[1]=Math.max(l[1],Math.min(a(.95),s+.5*r))),Xt(e)&&(l[0]=Math.min(l[0],Math.max(e-.05*r,i-2*r)),l[1]=Math.max(l[1],Math.min(e+.05*r,s+2*r))),l}function bT(n,t){let e=Math.max(6,Math.floor(t/6.2)),i=[];for(let s of n.split(/(?<=[/\s])/)){let r=i.at(-1);r!==void 0&&(r+s).trimEnd().length<=e?i[i.length-1]+=s:i.push(s)}return i.map(s=>s.trim())}var Vf=({name:n,unit:t})=>t?`${n} [${t}]`:n;function p_(n,t,e,i){let s=bT(n,t),r=s.length>3?[...s.slice(0,2),`${s[2]}\u2026`]:s;return ct("text",{class:"name","text-anchor":"middle",...e},...r.map((o,a)=>ct("tspan",{x:0,dy:a===0?0:i},o)))}var Gf=(n,t)=>ct("line",{class:n,...t});function wT(n,t){let e=zf(n.draws),i=n.prior?zf(n.prior):{x:[],y:[]},s=Math.max(...e.y,0)*1.08||1,r=gn([0,s],[t.bottom,t.top]),o=({x:u,y:d})=>u.map((f,m)=>[t.x(f),r(d[m])]),a=o(e),l=a.length?`${xr(a)}L${a.at(-1)[0].toFixed(1)} ${t.bottom}L${a[0][0].toFixed(1)} ${t.bottom}Z`:"",c=n.draws.reduce((u,d)=>u+d,0)/n.draws.length,h=ct("g",{role:"img","clip-path":`url(#${t.clip})`},ct("rect",{class:"catch",x:t.left,y:t.top,width:t.side,height:t.side}),ct("path",{class:"prior-line",d:xr(o(i))}),ct("path",{class:"density",d:l}),Xt(n.truth)?Gf("truth",{x1:t.x(n.truth),x2:t.x(n.truth),y1:t.top,y2:t.bottom}):null);return Fi(h,[Vf(n),`mean ${Ot(c)}, sd ${Ot($r(n.draws))}`,...Xt(n.truth)?[`truth ${Ot(n.truth)}`]:[]])}var m_=(n,t)=>n.map(e=>`${xr(e.map(([i,s])=>[t.x(i),t.y(s)]))}Z`).join("");function ET(n,t,e){let{rings:i,outside:s}=kf(n.draws,t.draws,ST),r=f_(n.draws,t.draws),a=n.prior&&t.prior&&n.prior.length===t.prior.length?kf(n.prior,t.prior,[.9]).rings[0]:[],l=s.map(([d,f])=>`M${e.x(d).toFixed(1)} ${e.y(f).toFixed(1)}h0`).join(""),c={x1:e.x(n.truth),x2:e.x(n.truth),y1:e.top,y2:e.bottom},h={y1:e.y(t.truth),y2:e.y(t.truth),x1:e.left,x2:e.right},u=ct("g",{role:"img","clip-path":`url(#${e.clip})`,"aria-label":`${t.name} over ${n.name}, correlation ${r.toFixed(2)}`},ct("rect",{class:"catch",x:e.left,y:e.top,width:e.side,height:e.side}),ct("path",{class:"prior-line",d:m_(a,e)}),ct("path",{class:"outside",d:l}),...i.map(d=>ct("path",{class:"region",d:m_(d,e)})),Xt(n.truth)?Gf("truth",c):null,Xt(t.truth)?Gf("truth",h):null);return u.addEventListener("pointermove",d=>{let f=u.ownerSVGElement.getBoundingClientRect(),m=[d.clientX-f.left,d.clientY-f.top];Vs(d,[`${t.name} over ${n.name}`,`correlation ${r.toFixed(2)}`,`here ${Ot(Number(e.valueX(m[0]).toPrecision(3)))} ${n.unit??""}, ${Ot(Number(e.valueY(m[1]).toPrecision(3)))} ${t.unit??""}`])}),u.addEventListener("pointerleave",Oi),u}var AT=0;function TT(n,t,e,i,s){let r=i+n*e+nu,o=eu+t*e,a=e-nu,l=s[n],c=s[t];return{left:r,right:r+a,top:o,bottom:o+a,side:a,clip:`corner-clip-${++AT}`,x:gn(l,[r,r+a]),y:gn(c,[o+a,o]),valueX:gn([r,r+a],l),valueY:gn([o+a,o],c)}}function CT(n,t,e,i,s){let r=n.side<100?2:3,o={x:n.left,y:n.top,width:n.side,height:n.side},a=[ct("clipPath",{id:n.clip},ct("rect",o)),ct("rect",{class:"panel-frame",...o})],l=si(...s.across,r).flatMap(h=>[ct("line",{class:"grid",x1:n.x(h),x2:n.x(h),y1:n.top,y2:n.bottom}),e===i?ct("text",{x:n.x(h),y:n.bottom+14,"text-anchor":"middle"},Ot(h)):null]),c=t===e?[]:si(...s.up,r).flatMap(h=>[ct("line",{class:"grid",x1:n.left,x2:n.right,y1:n.y(h),y2:n.y(h)}),t===0?ct("text",{x:n.left-4,y:n.y(h)+4,"text-anchor":"end"},Ot(h)):null]);return[...a,...l,...c]}function g_(n,t,e){let i=n.map(MT),s=n.length-1,r=[];n.forEach((l,c)=>{for(let d=0;d<=c;++d){let f=TT(d,c,t,e,i);r.push(...CT(f,d,c,s,{across:i[d],up:i[c]}),d===c?wT(l,f):ET(n[d],l,f))}let h=eu+(c+.5)*t-nu/2,u=e+(c+.5)*t+nu/2;r.push(c>0?p_(Vf(l),t,{transform:`translate(14 ${h}) rotate(-90)`},13):null,p_(Vf(l),t,{transform:`translate(${u} ${eu+n.length*t+26})`},13))});let o=e+n.length*t+4,a=eu+n.length*t+vT;return ct("svg",{class:"plot corner-plot",width:o,height:a,viewBox:`0 0 ${o} ${a}`,role:"group","aria-label":`Corner plot of ${n.map(({name:l})=>l).join(", ")}`},...r)}var iu=8,__=76,Hf=96;function RT(n,t,e){let i=t.map(a=>q("button",{type:"button",class:"chip",title:`Leave out ${n[a].name}`,disabled:t.length<3,onclick:()=>e(t.filter(l=>l!==a))},n[a].name,q("span",{"aria-hidden":"true"}," \xD7"))),s=n.map((a,l)=>[a,l]).filter(([,a])=>!t.includes(a));if(!s.length)return i;let r=t.length>=iu,o=q("select",{"aria-label":"Add a quantity",disabled:r,onchange:()=>e([...t,Number(o.value)])},q("option",{value:""},r?`${iu} at most`:"add a quantity"),...s.map(([a,l])=>q("option",{value:l},a.name)));return[...i,o]}function PT(n){let t=[{name:"50 % of draws",color:"color-mix(in srgb, var(--blue) 60%, var(--page))",mark:"box"},{name:"90 %",color:"color-mix(in srgb, var(--blue) 25%, var(--page))",mark:"box"}];return n.some(e=>e.prior)&&t.push({name:"prior",color:"var(--muted)",mark:"dash"}),n.some(e=>typeof e.truth=="number")&&t.push({name:"truth",color:"var(--vermillion)",mark:"line"}),_r(t)}function x_(n){let{quantities:t}=n,e=n.shown??t.slice(0,iu).map((a,l)=>l),i=!1,s=q("div",{class:"tools chooser"}),r=ms({class:"corner"},a=>{if(!i){let c=Math.max(2,Math.floor((a-Hf)/__));e.length>c&&o(e.slice(0,c),!1),i=!0}let l=Math.max(__,Math.min(170,(a-Hf-4)/e.length));return[g_(e.map(c=>t[c]),Math.floor(l),Hf)]});function o(a,l=!0){e=a,s.replaceChildren(...RT(t,e,o)),l&&r.redraw()}return o(e.slice(0,iu),!1),pn("figure",n.caption,s,PT(t),r)}var IT=24,LT=44,DT=620,NT=200,su=26,y_=42,Wf="var(--blue)";function v_(n){if(n.display)return n.display;if(!Xt(n.estimate))return"n/a";let t=Xt(n.low)&&Xt(n.high)?` [${Ot(n.low)}, ${Ot(n.high)}]`:"",e=n.unit&&n.unit!=="1"?` ${n.unit}`:"";return`${Ot(n.estimate)}${t}${e}`}var S_=n=>n.null?"not identifiable":v_(n),M_=(n,t)=>Xt(n)&&n>t,UT=(n,t)=>[n.estimate,n.high,n.prior_high,n.truth].some(e=>M_(e,t));function OT(n,t,e,i){let s=[];return Xt(n.prior_low)&&Xt(n.prior_high)&&s.push(ct("rect",{class:"prior",x:t(n.prior_low),width:Math.max(1,t(n.prior_high)-t(n.prior_low)),y:e-7,height:14,rx:3})),Xt(n.prior_inner_low)&&Xt(n.prior_inner_high)&&s.push(ct("rect",{class:"prior inner-prior",x:t(n.prior_inner_low),width:Math.max(1,t(n.prior_inner_high)-t(n.prior_inner_low)),y:e-7,height:14})),Xt(n.low)&&Xt(n.high)&&s.push(ct("line",{class:"whisker",x1:t(n.low),x2:t(n.high),y1:e,y2:e})),Xt(n.inner_low)&&Xt(n.inner_high)&&s.push(ct("line",{class:"inner",x1:t(n.inner_low),x2:t(n.inner_high),y1:e,y2:e})),Xt(n.estimate)&&!M_(n.estimate,i)&&s.push(ct("circle",{class:n.null?"hollow":"estimate",cx:t(n.estimate),cy:e,r:Xt(n.inner_low)?3.5:5})),Xt(n.truth)&&s.push(ct("path",{class:"truth",d:`M${t(n.truth)} ${e-8}v16`})),UT(n,i)&&s.push(ct("path",{class:"estimate",d:`M${t(i)+2} ${e-5}l8 5l-8 5z`})),s}var FT=n=>[n.name,v_(n),...Xt(n.inner_low)?[`inner ${Ot(n.inner_low)} to ${Ot(n.inner_high)}`]:[],...Xt(n.inner_low)&&Xt(n.low)?[`outer ${Ot(n.low)} to ${Ot(n.high)}`]:[],...n.null?["not identifiable"]:[],...Xt(n.prior_low)?[`prior ${Ot(n.prior_low)} to ${Ot(n.prior_high)}`]:[],...Xt(n.truth)?[`truth ${Ot(n.truth)}`]:[]];function BT(n,t,{x:e,most:i,left:s,right:r,width:o,narrow:a,row:l}){let c=a?t+24:t+l/2,h=a?t+14:c+4,u=a?{x:2}:{x:s-10,"text-anchor":"end"},d=a?{x:o-2,"text-anchor":"end"}:{x:r+12},f=ct("g",{class:`interval-row ${n.null?"null":""}`,style:`color: ${Wf}`,role:"img"},ct("rect",{class:"catch",x:0,y:t,width:o,height:l}),...OT(n,e,c,i),ct("text",{class:"name",y:h,...u},n.name),ct("text",{class:n.null?"note":"",y:h,...d},S_(n)));return Fi(f,FT(n))}function zT({rows:n,reference_lines:t=[],x_most:e=1/0},i){let s=n.flatMap(f=>[f.estimate,f.low,f.high,f.prior_low,f.prior_high,f.truth]).filter(Xt).map(f=>Math.min(f,e)),r=Ei([...s,...t.map(f=>f.value)],.04),o=18+Math.max(60,...n.map(f=>Gr(f.name))),a=Math.max(...n.map(f=>Gr(S_(f))),60),l=i<DT||i-o-a<NT,c=l?8:o,h=i-(l?8:24+a),u=gn(r,[c,h]);return{range:r,most:e,left:c,right:h,width:i,narrow:l,x:f=>u(Math.min(f,e)),row:l?LT:IT}}function kT(n,t){let e=zT(n,t),i=su+n.rows.length*e.row,s=(e.left+e.right)/2,r=Math.min(6,Math.max(2,Math.floor((e.right-e.left)/60)));return ct("svg",{class:"plot",width:t,height:i+y_,viewBox:`0 0 ${t} ${i+y_}`,role:"group","aria-label":n.caption??"Intervals"},...Ko(e.x,si(...e.range,r),su-4,i,n.x_label,s),...Qh(e.x,n.reference_lines??[],su-4,i),...n.rows.map((o,a)=>BT(o,su+a*e.row,e)))}function VT({rows:n,key:t}){let e=n.some(r=>Xt(r.inner_low)),s=[{name:t??(e?"estimate, inner and outer interval":"estimate and interval"),color:Wf,mark:"dot"}];return n.some(r=>Xt(r.prior_low))&&s.push({name:"prior",color:"var(--prior)",mark:"box"}),n.some(r=>Xt(r.truth))&&s.push({name:"truth",color:"var(--vermillion)",mark:"line"}),n.some(r=>r.null)&&s.push({name:"not identifiable",color:Wf,mark:"ring"}),_r(s)}var b_=n=>pn("figure",n.caption,VT(n),ms({class:"intervals"},t=>[kT(n,t)]));var GT="uplot",HT="u-hz",WT="u-vt",XT="u-title",$T="u-wrap",YT="u-under",qT="u-over",ZT="u-axis",Zr="u-off",JT="u-select",KT="u-cursor-x",jT="u-cursor-y",QT="u-cursor-pt",tC="u-legend",eC="u-live",nC="u-inline",iC="u-series",sC="u-marker",w_="u-label",rC="u-value",Tl="width",Cl="height";var E_="bottom",ta="left",Xf="right",lp="#000",A_=lp+"0",$f="mousemove",T_="mousedown",Yf="mouseup",C_="mouseenter",R_="mouseleave",P_="dblclick",oC="resize",aC="scroll",I_="change",cu="dppxchange",cp="--",aa=typeof window<"u",jf=aa?document:null,na=aa?window:null,lC=aa?navigator:null,Te,ru;function Qf(){let n=devicePixelRatio;Te!=n&&(Te=n,ru&&ep(I_,ru,Qf),ru=matchMedia(`(min-resolution: ${Te-.001}dppx) and (max-resolution: ${Te+.001}dppx)`),Jr(I_,ru,Qf),na.dispatchEvent(new CustomEvent(cu)))}function Ai(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function tp(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ze(n,t,e){n.style[t]=e+"px"}function Qi(n,t,e,i){let s=jf.createElement(n);return t!=null&&Ai(s,t),e?.insertBefore(s,i),s}function zi(n,t){return Qi("div",n,t)}var L_=new WeakMap;function ys(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=L_.get(n);r!=o&&(n.style.transform=r,L_.set(n,r),t<0||e<0||t>i||e>s?Ai(n,Zr):tp(n,Zr))}var D_=new WeakMap;function N_(n,t,e){let i=t+e,s=D_.get(n);i!=s&&(D_.set(n,i),n.style.background=t,n.style.borderColor=e)}var U_=new WeakMap;function O_(n,t,e,i){let s=t+""+e,r=U_.get(n);s!=r&&(U_.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var hp={passive:!0},cC={...hp,capture:!0};function Jr(n,t,e,i){t.addEventListener(n,e,i?cC:hp)}function ep(n,t,e,i){t.removeEventListener(n,e,hp)}aa&&Qf();function ts(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Ti((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function hx(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var ux=n=>n!=null,dx=n=>n!=null&&n>0,du=hx(ux),hC=hx(dx);function uC(n,t,e,i=0,s=!1){let r=s?hC:du,o=s?dx:ux;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??ze,l??-ze]}function fu(n,t,e,i){let s=z_(n),r=z_(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Gs:fx,a=s==1?Ti:ki,l=r==1?ki:Ti,c=a(o(Tn(n))),h=l(o(Tn(t))),u=ia(e,c),d=ia(e,h);return e==10&&(c<0&&(u=ke(u,-c)),h<0&&(d=ke(d,-h))),i||e==2?(n=u*s,t=d*r):(n=_x(n,u),t=pu(t,d)),[n,t]}function up(n,t,e,i){let s=fu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var dp=.1,F_={mode:3,pad:dp},Pl={pad:0,soft:null,mode:0},dC={min:Pl,max:Pl};function hu(n,t,e,i){return mu(e)?B_(n,t,e):(Pl.pad=e,Pl.soft=i?0:null,Pl.mode=i?3:0,B_(n,t,dC))}function Ee(n,t){return n??t}function fC(n,t,e){for(t=Ee(t,0),e=Ee(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function B_(n,t,e){let i=e.min,s=e.max,r=Ee(i.pad,0),o=Ee(s.pad,0),a=Ee(i.hard,-ze),l=Ee(s.hard,ze),c=Ee(i.soft,ze),h=Ee(s.soft,-ze),u=Ee(i.mode,0),d=Ee(s.mode,0),f=t-n,m=Gs(f),_=ri(Tn(n),Tn(t)),g=Gs(_),p=Tn(g-m);(f<1e-24||p>10)&&(f=0,(n==0||t==0)&&(f=1e-24,u==2&&c!=ze&&(r=0),d==2&&h!=-ze&&(o=0)));let v=f||_||1e3,T=Gs(v),S=ia(10,Ti(T)),C=v*(f==0?n==0?.1:1:r),A=ke(_x(n-C,S/10),24),x=n>=c&&(u==1||u==3&&A<=c||u==2&&A>=c)?c:ze,E=ri(a,A<x&&n>=x?x:es(x,A)),O=v*(f==0?t==0?.1:1:o),I=ke(pu(t+O,S/10),24),L=t<=h&&(d==1||d==3&&I>=h||d==2&&I<=h)?h:-ze,z=es(l,I>L&&t<=L?L:ri(L,I));return E==z&&E==0&&(z=100),[E,z]}var pC=new Intl.NumberFormat(aa?lC.language:"en-US"),fp=n=>pC.format(n),Ci=Math,lu=Ci.PI,Tn=Ci.abs,Ti=Ci.floor,An=Ci.round,ki=Ci.ceil,es=Ci.min,ri=Ci.max,ia=Ci.pow,z_=Ci.sign,Gs=Ci.log10,fx=Ci.log2,mC=(n,t=1)=>Ci.sinh(n)*t,qf=(n,t=1)=>Ci.asinh(n/t),ze=1/0;function k_(n){return(Gs((n^n>>31)-(n>>31))|0)+1}function np(n,t,e){return es(ri(n,t),e)}function px(n){return typeof n=="function"}function Me(n){return px(n)?n:()=>n}var gC=()=>{},mx=n=>n,gx=(n,t)=>t,_C=n=>null,V_=n=>!0,G_=(n,t)=>n==t,xC=/\.\d*?(?=9{6,}|0{6,})/gm,Kr=n=>{if(yx(n)||vr.has(n))return n;let t=`${n}`,e=t.match(xC);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Kr(s)}e${r}`}return ke(n,i)};function Yr(n,t){return Kr(ke(Kr(n/t))*t)}function pu(n,t){return Kr(ki(Kr(n/t))*t)}function _x(n,t){return Kr(Ti(Kr(n/t))*t)}function ke(n,t=0){if(yx(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return An(i)/e}var vr=new Map;function xx(n){return((""+n).split(".")[1]||"").length}function Ll(n,t,e,i){let s=[],r=i.map(xx);for(let o=t;o<e;o++){let a=Tn(o),l=ke(ia(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?h:ke(h,u);s.push(d),vr.set(d,u)}}return s}var Il={},pp=[],sa=[null,null],yr=Array.isArray,yx=Number.isInteger,yC=n=>n===void 0;function H_(n){return typeof n=="string"}function mu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function vC(n){return n!=null&&typeof n=="object"}var SC=Object.getPrototypeOf(Uint8Array),vx="__proto__";function ra(n,t=mu){let e;if(yr(n)){let i=n.find(s=>s!=null);if(yr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=ra(n[s],t)}else e=n.slice()}else if(n instanceof SC)e=n.slice();else if(t(n)){e={};for(let i in n)i!=vx&&(e[i]=ra(n[i],t))}else e=n;return e}function _n(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=vx&&(mu(n[s])?_n(n[s],ra(i[s])):n[s]=ra(i[s]))}return n}var MC=0,bC=1,wC=2;function EC(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function AC(n,t){if(RC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return PC(o[0])||(o=CC(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),d=t?t[o][c]:bC,f=[];for(let m=0;m<h.length;m++){let _=h[m],g=r.get(l[m]);_===null?d!=MC&&(u[g]=_,d==wC&&f.push(g)):u[g]=_}EC(u,f,s),i.push(u)}}return i}var TC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function CC(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function RC(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function PC(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ri(1,Ti((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Sx=["January","February","March","April","May","June","July","August","September","October","November","December"],Mx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function bx(n){return n.slice(0,3)}var IC=Mx.map(bx),LC=Sx.map(bx),DC={MMMM:Sx,MMM:LC,WWWW:Mx,WWW:IC};function Al(n){return(n<10?"0":"")+n}function NC(n){return(n<10?"00":n<100?"0":"")+n}var UC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Al(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Al(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Al(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Al(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Al(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>NC(n.getMilliseconds())};function mp(n,t){t=t||DC;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?UC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var OC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function FC(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==OC?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var wx=n=>n%1==0,uu=[1,2,2.5,5],BC=Ll(10,-32,0,uu),Ex=Ll(10,0,32,uu),zC=Ex.filter(wx),qr=BC.concat(Ex),gp=`
`,Ax="{YYYY}",W_=gp+Ax,Tx="{M}/{D}",Rl=gp+Tx,ou=Rl+"/{YY}",Cx="{aa}",kC="{h}:{mm}",ea=kC+Cx,X_=gp+ea,$_=":{ss}",Ie=null;function Rx(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ll(10,0,3,uu).filter(wx):Ll(10,-3,0,uu)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ax,Ie,Ie,Ie,Ie,Ie,Ie,1],[s*28,"{MMM}",W_,Ie,Ie,Ie,Ie,Ie,1],[s,Tx,W_,Ie,Ie,Ie,Ie,Ie,1],[i,"{h}"+Cx,ou,Ie,Rl,Ie,Ie,Ie,1],[e,ea,ou,Ie,Rl,Ie,Ie,Ie,1],[t,$_,ou+" "+ea,Ie,Rl+" "+ea,Ie,X_,Ie,1],[n,$_+".{fff}",ou+" "+ea,Ie,Rl+" "+ea,Ie,X_,Ie,1]];function h(u){return(d,f,m,_,g,p)=>{let v=[],T=g>=o,S=g>=r&&g<o,C=u(m),A=ke(C*n,3),x=Zf(C.getFullYear(),T?0:C.getMonth(),S||T?1:C.getDate()),E=ke(x*n,3);if(S||T){let O=S?g/r:0,I=T?g/o:0,L=A==E?A:ke(Zf(x.getFullYear()+I,x.getMonth()+O,1)*n,3),z=new Date(An(L/n)),V=z.getFullYear(),D=z.getMonth();for(let H=0;L<=_;H++){let $=Zf(V+I*H,D+O*H,1),G=$-u(ke($*n,3));L=ke((+$+G)*n,3),L<=_&&v.push(L)}}else{let O=g>=s?s:g,I=Ti(m)-Ti(A),L=E+I+pu(A-E,O);v.push(L);let z=u(L),V=z.getHours()+z.getMinutes()/e+z.getSeconds()/i,D=g/i,H=d.axes[f]._space,$=p/H;for(;L=ke(L+g,n==1?0:3),!(L>_);)if(D>1){let G=Ti(ke(V+D,6))%24,j=u(L).getHours()-G;j>1&&(j=-1),L-=j*i,V=(V+D)%24;let et=v[v.length-1];ke((L-et)/g,3)*$>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,h]}var[VC,GC,HC]=Rx(1),[WC,XC,$C]=Rx(.001);Ll(2,-53,53,[1]);function Y_(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function q_(n,t){return(e,i,s,r,o)=>{let a=t.find(m=>o>=m[0])||t[t.length-1],l,c,h,u,d,f;return i.map(m=>{let _=n(m),g=_.getFullYear(),p=_.getMonth(),v=_.getDate(),T=_.getHours(),S=_.getMinutes(),C=_.getSeconds(),A=g!=l&&a[2]||p!=c&&a[3]||v!=h&&a[4]||T!=u&&a[5]||S!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=p,h=v,u=T,d=S,f=C,A(_)})}}function YC(n,t){let e=mp(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Zf(n,t,e){return new Date(n,t,e)}function Z_(n,t){return t(n)}var qC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function J_(n,t){return(e,i,s,r)=>r==null?cp:t(n(i))}function ZC(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function JC(n,t){return n.series[t].fill(n,t)}var KC={show:!0,live:!0,isolate:!1,mount:gC,markers:{show:!0,width:2,stroke:ZC,fill:JC,dash:"solid"},idx:null,idxs:null,values:[]};function jC(n,t){let e=n.cursor.points,i=zi(),s=e.size(n,t);Ze(i,Tl,s),Ze(i,Cl,s);let r=s/-2;Ze(i,"marginLeft",r),Ze(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ze(i,"borderWidth",o),i}function QC(n,t){let e=n.series[t].points;return e._fill||e._stroke}function tR(n,t){let e=n.series[t].points;return e._stroke||e._fill}function eR(n,t){return n.series[t].points.size}var Jf=[0,0];function nR(n,t,e){return Jf[0]=t,Jf[1]=e,Jf}function au(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Kf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var iR={show:!0,x:!0,y:!0,lock:!1,move:nR,points:{one:!1,show:jC,size:eR,width:0,stroke:tR,fill:QC},bind:{mousedown:au,mouseup:au,click:au,dblclick:au,mousemove:Kf,mouseleave:Kf,mouseenter:Kf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Px={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},_p=_n({},Px,{filter:gx}),Ix=_n({},_p,{size:10}),Lx=_n({},Px,{show:!1}),xp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Dx="bold "+xp,Nx=1.5,K_={show:!0,scale:"x",stroke:lp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Dx,side:2,grid:_p,ticks:Ix,border:Lx,font:xp,lineGap:Nx,rotate:0},sR="Value",rR="Time",j_={show:!0,scale:"x",auto:!1,sorted:1,min:ze,max:-ze,idxs:[]};function oR(n,t,e,i,s){return t.map(r=>r==null?"":fp(r))}function aR(n,t,e,i,s,r,o){let a=[],l=vr.get(s)||0;e=o?e:ke(pu(e,s),l);for(let c=e;c<=i;c=ke(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ip(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Gs:fx,h=Ti(c(e));s=ia(l,h),l==10&&(s=qr[ts(s,qr)]);let u=e,d=s*l;l==10&&(d=qr[ts(d,qr)]);do a.push(u),u=u+s,l==10&&!vr.has(u)&&(u=ke(u,vr.get(s))),u>=d&&(s=u,d=s*l,l==10&&(d=qr[ts(d,qr)]));while(u<=i);return a}function lR(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?ip(n,t,ri(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?ip(n,t,ri(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(h,c)}var Ux=/./,cR=/[12357]/,hR=/[125]/,Q_=/1/,sp=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function uR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?Ux:l(7,o)-h>=c?cR:l(5,o)-h>=c?hR:Q_;if(u==Q_){let d=Tn(l(1,o)-h);if(d<c)return sp(t.slice().reverse(),a.distr,u,ki(c/d)).reverse()}return sp(t,a.distr,u,1)}function dR(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Tn(l(1,o)-l(2,o));return c<a?sp(t.slice().reverse(),3,Ux,ki(a/c)).reverse():t}function fR(n,t,e,i){return i==null?cp:t==null?"":fp(t)}var tx={show:!0,scale:"y",stroke:lp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Dx,side:3,grid:_p,ticks:Ix,border:Lx,font:xp,lineGap:Nx,rotate:0};function pR(n,t){let e=3+(n||1)*2;return ke(e*t,3)}function mR(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Tn(o-r),l=n.series[t],c=a/(l.points.space*Te);return i[1]-i[0]<=c}var ex={scale:null,auto:!0,sorted:0,min:ze,max:-ze},Ox=(n,t,e,i,s)=>s,nx={show:!0,auto:!0,sorted:0,gaps:Ox,alpha:1,facets:[_n({},ex,{scale:"x"}),_n({},ex,{scale:"y"})]},ix={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ox,alpha:1,points:{show:mR,filter:null},values:null,min:ze,max:-ze,idxs:[],path:null,clip:null};function gR(n,t,e,i,s){return e/10}var Fx={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},_R=_n({},Fx,{time:!1,ori:1}),sx={};function Bx(n,t){let e=sx[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(sx[n]=e)),e}var oa=1,rp=2;function jr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,m=a.width,_=a.height,g=n.valToPosH,p=n.valToPosV;return h.ori==0?e(s,l,c,h,u,g,p,d,f,m,_,_u,la,yu,kx,Gx):e(s,l,c,h,u,p,g,f,d,_,m,xu,ca,Sp,Vx,Hx)}function yp(n,t){let e=0,i=0,s=Ee(n.bands,pp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function xR(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Hs(n,t,e,i,s,r){return jr(n,t,(o,a,l,c,h,u,d,f,m,_,g)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?la:ca,S,C;v==1?(S=e,C=i):(S=i,C=e);let A=p(u(a[S],c,_,f)),x=p(d(l[S],h,g,m)),E=p(u(a[C],c,_,f)),O=p(d(r==1?h.max:h.min,h,g,m)),I=new Path2D(s);return T(I,E,O),T(I,A,O),T(I,A,x),I})}function gu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?yu:Sp,l=e;for(let u=0;u<n.length;u++){let d=n[u];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function yR(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function vp(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let u=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[u]),m=d==u?f:r(n[d]),_=u-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let p=d+s;m=o>=0&&p>=0&&p<l?r(n[p]):m,m>=f&&a.push([f,m])}return a}function rx(n){return n==0?mx:n==1?An:t=>Yr(t,n)}function zx(n){let t=n==0?_u:xu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=es(c,a/2,l/2),h=es(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var _u=(n,t,e)=>{n.moveTo(t,e)},xu=(n,t,e)=>{n.moveTo(e,t)},la=(n,t,e)=>{n.lineTo(t,e)},ca=(n,t,e)=>{n.lineTo(e,t)},yu=zx(0),Sp=zx(1),kx=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},Vx=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},Gx=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},Hx=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function Wx(n){return(t,e,i,s,r)=>jr(t,e,(o,a,l,c,h,u,d,f,m,_,g)=>{let{pxRound:p,points:v}=o,T,S;c.ori==0?(T=_u,S=kx):(T=xu,S=Vx);let C=ke(v.width*Te,3),A=(v.size-v.width)/2*Te,x=ke(A*2,3),E=new Path2D,O=new Path2D,{left:I,top:L,width:z,height:V}=t.bbox;yu(O,I-x,L-x,z+x*2,V+x*2);let D=H=>{if(l[H]!=null){let $=p(u(a[H],c,_,f)),G=p(d(l[H],h,g,m));T(E,$+A,G),S(E,$,G,A,0,lu*2)}};if(r)r.forEach(D);else for(let H=i;H<=s;H++)D(H);return{stroke:C>0?E:null,fill:E,clip:O,flags:oa|rp}})}function Xx(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var vR=Xx(la),SR=Xx(ca);function $x(n){let t=Ee(n?.alignGaps,0);return(e,i,s,r)=>jr(e,i,(o,a,l,c,h,u,d,f,m,_,g)=>{[s,r]=du(l,s,r);let p=o.pxRound,v=V=>p(u(V,c,_,f)),T=V=>p(d(V,h,g,m)),S,C;c.ori==0?(S=la,C=vR):(S=ca,C=SR);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:oa},E=x.stroke,O=!1;if(r-s>=_*4){let V=dt=>e.posToVal(dt,c.key,!0),D=null,H=null,$,G,lt,Z=v(a[A==1?s:r]),j=v(a[s]),et=v(a[r]),ft=V(A==1?j+1:et-1);for(let dt=A==1?s:r;dt>=s&&dt<=r;dt+=A){let tt=a[dt],yt=(A==1?tt<ft:tt>ft)?Z:v(tt),Ct=l[dt];yt==Z?Ct!=null?(G=Ct,D==null?(S(E,yt,T(G)),$=D=H=G):G<D?D=G:G>H&&(H=G)):Ct===null&&(O=!0):(D!=null&&C(E,Z,T(D),T(H),T($),T(G)),Ct!=null?(G=Ct,S(E,yt,T(G)),D=H=$=G):(D=H=null,Ct===null&&(O=!0)),Z=yt,ft=V(Z+A))}D!=null&&D!=H&&lt!=Z&&C(E,Z,T(D),T(H),T($),T(G))}else for(let V=A==1?s:r;V>=s&&V<=r;V+=A){let D=l[V];D===null?O=!0:D!=null&&S(E,v(a[V]),T(D))}let[L,z]=yp(e,i);if(o.fill!=null||L!=0){let V=x.fill=new Path2D(E),D=o.fillTo(e,i,o.min,o.max,L),H=T(D),$=v(a[s]),G=v(a[r]);A==-1&&([G,$]=[$,G]),S(V,G,H),S(V,$,H)}if(!o.spanGaps){let V=[];O&&V.push(...vp(a,l,s,r,A,v,t)),x.gaps=V=o.gaps(e,i,s,r,V),x.clip=gu(V,c.ori,f,m,_,g)}return z!=0&&(x.band=z==2?[Hs(e,i,s,r,E,-1),Hs(e,i,s,r,E,1)]:Hs(e,i,s,r,E,z)),x})}function MR(n){let t=Ee(n.align,1),e=Ee(n.ascDesc,!1),i=Ee(n.alignGaps,0),s=Ee(n.extend,!1);return(r,o,a,l)=>jr(r,o,(c,h,u,d,f,m,_,g,p,v,T)=>{[a,l]=du(u,a,l);let S=c.pxRound,{left:C,width:A}=r.bbox,x=j=>S(m(j,d,v,g)),E=j=>S(_(j,f,T,p)),O=d.ori==0?la:ca,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:oa},L=I.stroke,z=d.dir*(d.ori==0?1:-1),V=E(u[z==1?a:l]),D=x(h[z==1?a:l]),H=D,$=D;s&&t==-1&&($=C,O(L,$,V)),O(L,D,V);for(let j=z==1?a:l;j>=a&&j<=l;j+=z){let et=u[j];if(et==null)continue;let ft=x(h[j]),dt=E(et);t==1?O(L,ft,V):O(L,H,dt),O(L,ft,dt),V=dt,H=ft}let G=H;s&&t==1&&(G=C+A,O(L,G,V));let[lt,Z]=yp(r,o);if(c.fill!=null||lt!=0){let j=I.fill=new Path2D(L),et=c.fillTo(r,o,c.min,c.max,lt),ft=E(et);O(j,G,ft),O(j,$,ft)}if(!c.spanGaps){let j=[];j.push(...vp(h,u,a,l,z,x,i));let et=c.width*Te/2,ft=e||t==1?et:-et,dt=e||t==-1?-et:et;j.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),I.gaps=j=c.gaps(r,o,a,l,j),I.clip=gu(j,d.ori,g,p,v,T)}return Z!=0&&(I.band=Z==2?[Hs(r,o,a,l,L,-1),Hs(r,o,a,l,L,1)]:Hs(r,o,a,l,L,Z)),I})}function ox(n,t,e,i,s,r,o=ze){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=Tn(n[l]-n[a]);h<c&&(c=h,o=Tn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function bR(n){n=n||Il;let t=Ee(n.size,[.6,ze,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Me(s),o=1-t[0],a=Ee(t[1],ze),l=Ee(t[2],1),c=Ee(n.disp,Il),h=Ee(n.each,f=>{}),{fill:u,stroke:d}=c;return(f,m,_,g)=>jr(f,m,(p,v,T,S,C,A,x,E,O,I,L)=>{let z=p.pxRound,V=e,D=i*Te,H=a*Te,$=l*Te,G,lt;S.ori==0?[G,lt]=r(f,m):[lt,G]=r(f,m);let Z=S.dir*(S.ori==0?1:-1),j=S.ori==0?yu:Sp,et=S.ori==0?h:(Pt,Kt,le,wt,Be,Gt,qt)=>{h(Pt,Kt,le,Be,wt,qt,Gt)},ft=Ee(f.bands,pp).find(Pt=>Pt.series[0]==m),dt=ft!=null?ft.dir:0,tt=p.fillTo(f,m,p.min,p.max,dt),gt=z(x(tt,C,L,O)),yt,Ct,bt,$t=I,ae=z(p.width*Te),Ht=!1,pe=null,ue=null,re=null,Je=null;u!=null&&(ae==0||d!=null)&&(Ht=!0,pe=u.values(f,m,_,g),ue=new Map,new Set(pe).forEach(Pt=>{Pt!=null&&ue.set(Pt,new Path2D)}),ae>0&&(re=d.values(f,m,_,g),Je=new Map,new Set(re).forEach(Pt=>{Pt!=null&&Je.set(Pt,new Path2D)})));let{x0:Ve,size:ln}=c;if(Ve!=null&&ln!=null){V=1,v=Ve.values(f,m,_,g),Ve.unit==2&&(v=v.map(le=>f.posToVal(E+le*I,S.key,!0)));let Pt=ln.values(f,m,_,g);ln.unit==2?Ct=Pt[0]*I:Ct=A(Pt[0],S,I,E)-A(0,S,I,E),$t=ox(v,T,A,S,I,E,$t),bt=$t-Ct+D}else $t=ox(v,T,A,S,I,E,$t),bt=$t*o+D,Ct=$t-bt;bt<1&&(bt=0),ae>=Ct/2&&(ae=0),bt<5&&(z=mx);let Ue=bt>0,Rn=$t-bt-(Ue?ae:0);Ct=z(np(Rn,$,H)),yt=(V==0?Ct/2:V==Z?0:Ct)-V*Z*((V==0?D/2:0)+(Ue?ae/2:0));let be={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},yn=Ht?null:new Path2D,tn=null;if(ft!=null)tn=f.data[ft.series[1]];else{let{y0:Pt,y1:Kt}=c;Pt!=null&&Kt!=null&&(T=Kt.values(f,m,_,g),tn=Pt.values(f,m,_,g))}let cn=G*Ct,B=lt*Ct;for(let Pt=Z==1?_:g;Pt>=_&&Pt<=g;Pt+=Z){let Kt=T[Pt];if(Kt==null)continue;if(tn!=null){let X=tn[Pt]??0;if(Kt-X==0)continue;gt=x(X,C,L,O)}let le=S.distr!=2||c!=null?v[Pt]:Pt,wt=A(le,S,I,E),Be=x(Ee(Kt,tt),C,L,O),Gt=z(wt-yt),qt=z(ri(Be,gt)),R=z(es(Be,gt)),M=qt-R;if(Kt!=null){let X=Kt<0?B:cn,ut=Kt<0?cn:B;Ht?(ae>0&&re[Pt]!=null&&j(Je.get(re[Pt]),Gt,R+Ti(ae/2),Ct,ri(0,M-ae),X,ut),pe[Pt]!=null&&j(ue.get(pe[Pt]),Gt,R+Ti(ae/2),Ct,ri(0,M-ae),X,ut)):j(yn,Gt,R+Ti(ae/2),Ct,ri(0,M-ae),X,ut),et(f,m,Pt,Gt-ae/2,R,Ct+ae,M)}}return ae>0?be.stroke=Ht?Je:yn:Ht||(be._fill=p.width==0?p._fill:p._stroke??p._fill,be.width=0),be.fill=Ht?ue:yn,be})}function wR(n,t){let e=Ee(t?.alignGaps,0);return(i,s,r,o)=>jr(i,s,(a,l,c,h,u,d,f,m,_,g,p)=>{[r,o]=du(c,r,o);let v=a.pxRound,T=G=>v(d(G,h,g,m)),S=G=>v(f(G,u,p,_)),C,A,x;h.ori==0?(C=_u,x=la,A=Gx):(C=xu,x=ca,A=Hx);let E=h.dir*(h.ori==0?1:-1),O=T(l[E==1?r:o]),I=O,L=[],z=[];for(let G=E==1?r:o;G>=r&&G<=o;G+=E)if(c[G]!=null){let Z=l[G],j=T(Z);L.push(I=j),z.push(S(c[G]))}let V={stroke:n(L,z,C,x,A,v),fill:null,clip:null,band:null,gaps:null,flags:oa},D=V.stroke,[H,$]=yp(i,s);if(a.fill!=null||H!=0){let G=V.fill=new Path2D(D),lt=a.fillTo(i,s,a.min,a.max,H),Z=S(lt);x(G,I,Z),x(G,O,Z)}if(!a.spanGaps){let G=[];G.push(...vp(l,c,r,o,E,T,e)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=gu(G,h.ori,m,_,g,p)}return $!=0&&(V.band=$==2?[Hs(i,s,r,o,D,-1),Hs(i,s,r,o,D,1)]:Hs(i,s,r,o,D,$)),V})}function ER(n){return wR(AR,n)}function AR(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let d=0;d<o-1;d++)h[d]=t[d+1]-t[d],u[d]=n[d+1]-n[d],c[d]=h[d]/u[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(u[d-1]+u[d])/((2*u[d]+u[d-1])/c[d-1]+(u[d]+2*u[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+u[d]/3,t[d]+l[d]*u[d]/3,n[d+1]-u[d]/3,t[d+1]-l[d+1]*u[d]/3,n[d+1],t[d+1])}return a}var op=new Set;function ax(){for(let n of op)n.syncRect(!0)}aa&&(Jr(oC,na,ax),Jr(aC,na,ax,!0),Jr(cu,na,()=>{kn.pxRatio=Te}));var TR=$x(),CR=Wx();function lx(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>ap(r,o,t,e))}function RR(n,t){return n.map((e,i)=>i==0?{}:_n({},t,e))}function ap(n,t,e,i){return _n({},t==0?e:i,n)}function Yx(n,t,e){return t==null?sa:[t,e]}var PR=Yx;function IR(n,t,e){return t==null?sa:hu(t,e,dp,!0)}function qx(n,t,e,i){return t==null?sa:fu(t,e,n.scales[i].log,!1)}var LR=qx;function Zx(n,t,e,i){return t==null?sa:up(t,e,n.scales[i].log,!1)}var DR=Zx;function NR(n,t,e,i,s){let r=ri(k_(n),k_(t)),o=t-n,a=ts(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?vr.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function cx(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=An((e=+s)*Te))+"px"),[n,t,e]}function UR(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=ke(t[2]*Te,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function kn(n,t,e){let i={mode:Ee(n.mode,1)},s=i.mode;function r(y,b,P,N){let W=b.valToPct(y);return N+P*(b.dir==-1?1-W:W)}function o(y,b,P,N){let W=b.valToPct(y);return N+P*(b.dir==-1?W:1-W)}function a(y,b,P,N){return b.ori==0?r(y,b,P,N):o(y,b,P,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=zi(GT);if(n.id!=null&&(c.id=n.id),Ai(c,n.class),n.title){let y=zi(XT,c);y.textContent=n.title}let h=Qi("canvas"),u=i.ctx=h.getContext("2d"),d=zi($T,c);Jr("click",d,y=>{y.target===m&&(We!=ao||Ke!=lo)&&Bn.click(i,y)},!0);let f=i.under=zi(YT,d);d.appendChild(h);let m=i.over=zi(qT,d);n=ra(n);let _=+Ee(n.pxAlign,1),g=rx(_);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let p=n.ms||.001,v=i.series=s==1?lx(n.series||[],j_,ix,!1):RR(n.series||[null],nx),T=i.axes=lx(n.axes||[],K_,tx,!0),S=i.scales={},C=i.bands=n.bands||[];C.forEach(y=>{y.fill=Me(y.fill||null),y.dir=Ee(y.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,x={axes:As,series:ge},E=(n.drawOrder||["axes","series"]).map(y=>x[y]);function O(y){let b=y.distr==3?P=>Gs(P>0?P:y.clamp(i,P,y.min,y.max,y.key)):y.distr==4?P=>qf(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let N=b(P),{_min:W,_max:K}=y,at=K-W;return(N-W)/at}}function I(y){let b=S[y];if(b==null){let P=(n.scales||Il)[y]||Il;if(P.from!=null){I(P.from);let N=_n({},S[P.from],P,{key:y});N.valToPct=O(N),S[y]=N}else{b=S[y]=_n({},y==A?Fx:_R,P),b.key=y;let N=b.time,W=b.range,K=yr(W);if((y!=A||s==2&&!N)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?F_:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?F_:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&mu(W))){let at=W;W=(pt,St,Nt)=>St==null?sa:hu(St,Nt,at)}b.range=Me(W||(N?PR:y==A?b.distr==3?LR:b.distr==4?DR:Yx:b.distr==3?qx:b.distr==4?Zx:IR)),b.auto=Me(K?!1:b.auto),b.clamp=Me(b.clamp||gR),b._min=b._max=null,b.valToPct=O(b)}}}I("x"),I("y"),s==1&&v.forEach(y=>{I(y.scale)}),T.forEach(y=>{I(y.scale)});for(let y in n.scales)I(y);let L=S[A],z=L.distr,V,D;L.ori==0?(Ai(c,HT),V=r,D=o):(Ai(c,WT),V=o,D=r);let H={};for(let y in S){let b=S[y];(b.min!=null||b.max!=null)&&(H[y]={min:b.min,max:b.max},b.min=b.max=null)}let $=n.tzDate||(y=>new Date(An(y/p))),G=n.fmtDate||mp,lt=p==1?HC($):$C($),Z=q_($,Y_(p==1?GC:XC,G)),j=J_($,Z_(qC,G)),et=[],ft=i.legend=_n({},KC,n.legend),dt=i.cursor=_n({},iR,{drag:{y:s==2}},n.cursor),tt=ft.show,gt=dt.show,yt=ft.markers;ft.idxs=et,yt.width=Me(yt.width),yt.dash=Me(yt.dash),yt.stroke=Me(yt.stroke),yt.fill=Me(yt.fill);let Ct,bt,$t,ae=[],Ht=[],pe,ue=!1,re={};if(ft.live){let y=v[1]?v[1].values:null;ue=y!=null,pe=ue?y(i,1,0):{_:0};for(let b in pe)re[b]=cp}if(tt)if(Ct=Qi("table",tC,c),$t=Qi("tbody",null,Ct),ft.mount(i,Ct),ue){bt=Qi("thead",null,Ct,$t);let y=Qi("tr",null,bt);Qi("th",null,y);for(var Je in pe)Qi("th",w_,y).textContent=Je}else Ai(Ct,nC),ft.live&&Ai(Ct,eC);let Ve={show:!0},ln={show:!1};function Ue(y,b){if(b==0&&(ue||!ft.live||s==2))return sa;let P=[],N=Qi("tr",iC,$t,$t.childNodes[b]);Ai(N,y.class),y.show||Ai(N,Zr);let W=Qi("th",null,N);if(yt.show){let pt=zi(sC,W);if(b>0){let St=yt.width(i,b);St&&(pt.style.border=St+"px "+yt.dash(i,b)+" "+yt.stroke(i,b)),pt.style.background=yt.fill(i,b)}}let K=zi(w_,W);y.label instanceof HTMLElement?K.appendChild(y.label):K.textContent=y.label,b>0&&(yt.show||(K.style.color=y.width>0?yt.stroke(i,b):yt.fill(i,b)),be("click",W,pt=>{if(dt._lock)return;Qt(pt);let St=v.indexOf(y);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=v.some((Ut,Bt)=>Bt>0&&Bt!=St&&Ut.show);v.forEach((Ut,Bt)=>{Bt>0&&rs(Bt,Nt?Bt==St?Ve:ln:Ve,!0,fn.setSeries)})}else rs(St,{show:!y.show},!0,fn.setSeries)},!1),te&&be(C_,W,pt=>{dt._lock||(Qt(pt),rs(v.indexOf(y),ho,!0,fn.setSeries))},!1));for(var at in pe){let pt=Qi("td",rC,N);pt.textContent="--",P.push(pt)}return[N,P]}let Rn=new Map;function be(y,b,P,N=!0){let W=Rn.get(b)||{},K=dt.bind[y](i,b,P,N);K&&(Jr(y,b,W[y]=K),Rn.set(b,W))}function yn(y,b,P){let N=Rn.get(b)||{};for(let W in N)(y==null||W==y)&&(ep(W,b,N[W]),delete N[W]);y==null&&Rn.delete(b)}let tn=0,cn=0,B=0,Pt=0,Kt=0,le=0,wt=Kt,Be=le,Gt=B,qt=Pt,R=0,M=0,X=0,ut=0;i.bbox={};let ot=!1,xt=!1,vt=!1,nt=!1,st=!1,mt=!1;function F(y,b,P){(P||y!=i.width||b!=i.height)&&rt(y,b),de(!1),vt=!0,xt=!0,Wn()}function rt(y,b){i.width=tn=B=y,i.height=cn=Pt=b,Kt=le=0,Mt(),Wt();let P=i.bbox;R=P.left=Yr(Kt*Te,.5),M=P.top=Yr(le*Te,.5),X=P.width=Yr(B*Te,.5),ut=P.height=Yr(Pt*Te,.5)}let it=3;function Et(){let y=!1,b=0;for(;!y;){b++;let P=so(b),N=ss(b);y=b==it||P&&N,y||(rt(i.width,i.height),xt=!0)}}function _t({width:y,height:b}){F(y,b)}i.setSize=_t;function Mt(){let y=!1,b=!1,P=!1,N=!1;T.forEach((W,K)=>{if(W.show&&W._show){let{side:at,_size:pt}=W,St=at%2,Nt=W.label!=null?W.labelSize:0,Ut=pt+Nt;Ut>0&&(St?(B-=Ut,at==3?(Kt+=Ut,N=!0):P=!0):(Pt-=Ut,at==0?(le+=Ut,y=!0):b=!0))}}),ns[0]=y,ns[1]=P,ns[2]=b,ns[3]=N,B-=Gi[1]+Gi[3],Kt+=Gi[3],Pt-=Gi[2]+Gi[0],le+=Gi[0]}function Wt(){let y=Kt+B,b=le+Pt,P=Kt,N=le;function W(K,at){switch(K){case 1:return y+=at,y-at;case 2:return b+=at,b-at;case 3:return P-=at,P+at;case 0:return N-=at,N+at}}T.forEach((K,at)=>{if(K.show&&K._show){let pt=K.side;K._pos=W(pt,K._size),K.label!=null&&(K._lpos=W(pt,K.labelSize))}})}if(dt.dataIdx==null){let y=dt.hover,b=y.skip=new Set(y.skip??[]);b.add(void 0);let P=y.prox=Me(y.prox),N=y.bias??(y.bias=0);dt.dataIdx=(W,K,at,pt)=>{if(K==0)return at;let St=at,Nt=P(W,K,at,pt)??ze,Ut=Nt>=0&&Nt<ze,Bt=L.ori==0?B:Pt,oe=dt.left,Ae=t[0],we=t[K];if(b.has(we[at])){St=null;let _e=null,jt=null,Yt;if(N==0||N==-1)for(Yt=at;_e==null&&Yt-- >0;)b.has(we[Yt])||(_e=Yt);if(N==0||N==1)for(Yt=at;jt==null&&Yt++<we.length;)b.has(we[Yt])||(jt=Yt);if(_e!=null||jt!=null)if(Ut){let $e=_e==null?-1/0:V(Ae[_e],L,Bt,0),sn=jt==null?1/0:V(Ae[jt],L,Bt,0),Dn=oe-$e,Oe=sn-oe;Dn<=Oe?Dn<=Nt&&(St=_e):Oe<=Nt&&(St=jt)}else St=jt==null?_e:_e==null?jt:at-_e<=jt-at?_e:jt}else Ut&&Tn(oe-V(Ae[at],L,Bt,0))>Nt&&(St=null);return St}}let Qt=y=>{dt.event=y};dt.idxs=et,dt._lock=!1;let ht=dt.points;ht.show=Me(ht.show),ht.size=Me(ht.size),ht.stroke=Me(ht.stroke),ht.width=Me(ht.width),ht.fill=Me(ht.fill);let zt=i.focus=_n({},n.focus||{alpha:.3},dt.focus),te=zt.prox>=0,Rt=te&&ht.one,he=[],He=[],Zn=[];function ga(y,b){let P=ht.show(i,b);if(P instanceof HTMLElement)return Ai(P,QT),Ai(P,y.class),ys(P,-10,-10,B,Pt),m.insertBefore(P,he[b]),P}function eo(y,b){if(s==1||b>0){let P=s==1&&S[y.scale].time,N=y.value;y.value=P?H_(N)?J_($,Z_(N,G)):N||j:N||fR,y.label=y.label||(P?rR:sR)}if(Rt||b>0){y.width=y.width==null?1:y.width,y.paths=y.paths||TR||_C,y.fillTo=Me(y.fillTo||xR),y.pxAlign=+Ee(y.pxAlign,_),y.pxRound=rx(y.pxAlign),y.stroke=Me(y.stroke||null),y.fill=Me(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=pR(ri(1,y.width),1),N=y.points=_n({},{size:P,width:ri(1,P*.2),stroke:y.stroke,space:P*2,paths:CR,_stroke:null,_fill:null},y.points);N.show=Me(N.show),N.filter=Me(N.filter),N.fill=Me(N.fill),N.stroke=Me(N.stroke),N.paths=Me(N.paths),N.pxAlign=y.pxAlign}if(tt){let P=Ue(y,b);ae.splice(b,0,P[0]),Ht.splice(b,0,P[1]),ft.values.push(null)}if(gt){et.splice(b,0,null);let P=null;Rt?b==0&&(P=ga(y,b)):b>0&&(P=ga(y,b)),he.splice(b,0,P),He.splice(b,0,0),Zn.splice(b,0,0)}Ln("addSeries",b)}function Bu(y,b){b=b??v.length,y=s==1?ap(y,b,j_,ix):ap(y,b,{},nx),v.splice(b,0,y),eo(v[b],b)}i.addSeries=Bu;function Gl(y){if(v.splice(y,1),tt){ft.values.splice(y,1),Ht.splice(y,1);let b=ae.splice(y,1)[0];yn(null,b.firstChild),b.remove()}gt&&(et.splice(y,1),he.splice(y,1)[0].remove(),He.splice(y,1),Zn.splice(y,1)),Ln("delSeries",y)}i.delSeries=Gl;let ns=[!1,!1,!1,!1];function bs(y,b){if(y._show=y.show,y.show){let P=y.side%2,N=S[y.scale];N==null&&(y.scale=P?v[1].scale:A,N=S[y.scale]);let W=N.time;y.size=Me(y.size),y.space=Me(y.space),y.rotate=Me(y.rotate),yr(y.incrs)&&y.incrs.forEach(at=>{!vr.has(at)&&vr.set(at,xx(at))}),y.incrs=Me(y.incrs||(N.distr==2?zC:W?p==1?VC:WC:qr)),y.splits=Me(y.splits||(W&&N.distr==1?lt:N.distr==3?ip:N.distr==4?lR:aR)),y.stroke=Me(y.stroke),y.grid.stroke=Me(y.grid.stroke),y.ticks.stroke=Me(y.ticks.stroke),y.border.stroke=Me(y.border.stroke);let K=y.values;y.values=yr(K)&&!yr(K[0])?Me(K):W?yr(K)?q_($,Y_(K,G)):H_(K)?YC($,K):K||Z:K||oR,y.filter=Me(y.filter||(N.distr>=3&&N.log==10?uR:N.distr==3&&N.log==2?dR:gx)),y.font=cx(y.font),y.labelFont=cx(y.labelFont),y._size=y.size(i,null,b,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(ns[b]=!0,y._el=zi(ZT,d))}}function ws(y,b,P,N){let[W,K,at,pt]=P,St=b%2,Nt=0;return St==0&&(pt||K)&&(Nt=b==0&&!W||b==2&&!at?An(K_.size/3):0),St==1&&(W||at)&&(Nt=b==1&&!K||b==3&&!pt?An(tx.size/2):0),Nt}let _a=i.padding=(n.padding||[ws,ws,ws,ws]).map(y=>Me(Ee(y,ws))),Gi=i._padding=_a.map((y,b)=>y(i,b,ns,0)),en,on=null,an=null,is=s==1?v[0].idxs:null,di=null,Ws=!1;function xa(y,b){if(t=y??[],i.data=i._data=t,s==2){en=0;for(let P=1;P<v.length;P++)en+=t[P][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),di=t[0],en=di.length;let P=t;if(z==2){P=t.slice();let N=P[0]=Array(en);for(let W=0;W<en;W++)N[W]=W}i._data=t=P}if(de(!0),Ln("setData"),z==2&&(vt=!0),b!==!1){let P=L;P.auto(i,Ws)?ya():Ys(A,P.min,P.max),nt=nt||dt.left>=0,mt=!0,Wn()}}i.setData=xa;function ya(){Ws=!0;let y,b;s==1&&(en>0?(on=is[0]=0,an=is[1]=en-1,y=t[0][on],b=t[0][an],z==2?(y=on,b=an):y==b&&(z==3?[y,b]=fu(y,y,L.log,!1):z==4?[y,b]=up(y,y,L.log,!1):L.time?b=y+An(86400/p):[y,b]=hu(y,b,dp,!0))):(on=is[0]=y=null,an=is[1]=b=null)),Ys(A,y,b)}let no,Xs,io,w,k,Q,Y,J,At,Lt;function Tt(y,b,P,N,W,K){y??(y=A_),P??(P=pp),N??(N="butt"),W??(W=A_),K??(K="round"),y!=no&&(u.strokeStyle=no=y),W!=Xs&&(u.fillStyle=Xs=W),b!=io&&(u.lineWidth=io=b),K!=k&&(u.lineJoin=k=K),N!=Q&&(u.lineCap=Q=N),P!=w&&u.setLineDash(w=P)}function Dt(y,b,P,N){b!=Xs&&(u.fillStyle=Xs=b),y!=Y&&(u.font=Y=y),P!=J&&(u.textAlign=J=P),N!=At&&(u.textBaseline=At=N)}function Vt(y,b,P,N,W=0){if(N.length>0&&y.auto(i,Ws)&&(b==null||b.min==null)){let K=Ee(on,0),at=Ee(an,N.length-1),pt=P.min==null?uC(N,K,at,W,y.distr==3):[P.min,P.max];y.min=es(y.min,P.min=pt[0]),y.max=ri(y.max,P.max=pt[1])}}let ie={min:null,max:null};function me(){for(let N in S){let W=S[N];H[N]==null&&(W.min==null||H[A]!=null&&W.auto(i,Ws))&&(H[N]=ie)}for(let N in S){let W=S[N];H[N]==null&&W.from!=null&&H[W.from]!=null&&(H[N]=ie)}H[A]!=null&&de(!0);let y={};for(let N in H){let W=H[N];if(W!=null){let K=y[N]=ra(S[N],vC);if(W.min!=null)_n(K,W);else if(N!=A||s==2)if(en==0&&K.from==null){let at=K.range(i,null,null,N);K.min=at[0],K.max=at[1]}else K.min=ze,K.max=-ze}}if(en>0){v.forEach((N,W)=>{if(s==1){let K=N.scale,at=H[K];if(at==null)return;let pt=y[K];if(W==0){let St=pt.range(i,pt.min,pt.max,K);pt.min=St[0],pt.max=St[1],on=ts(pt.min,t[0]),an=ts(pt.max,t[0]),an-on>1&&(t[0][on]<pt.min&&on++,t[0][an]>pt.max&&an--),N.min=di[on],N.max=di[an]}else N.show&&N.auto&&Vt(pt,at,N,t[W],N.sorted);N.idxs[0]=on,N.idxs[1]=an}else if(W>0&&N.show&&N.auto){let[K,at]=N.facets,pt=K.scale,St=at.scale,[Nt,Ut]=t[W],Bt=y[pt],oe=y[St];Bt!=null&&Vt(Bt,H[pt],K,Nt,K.sorted),oe!=null&&Vt(oe,H[St],at,Ut,at.sorted),N.min=at.min,N.max=at.max}});for(let N in y){let W=y[N],K=H[N];if(W.from==null&&(K==null||K.min==null)){let at=W.range(i,W.min==ze?null:W.min,W.max==-ze?null:W.max,N);W.min=at[0],W.max=at[1]}}}for(let N in y){let W=y[N];if(W.from!=null){let K=y[W.from];if(K.min==null)W.min=W.max=null;else{let at=W.range(i,K.min,K.max,N);W.min=at[0],W.max=at[1]}}}let b={},P=!1;for(let N in y){let W=y[N],K=S[N];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let at=K.distr;K._min=at==3?Gs(K.min):at==4?qf(K.min,K.asinh):at==100?K.fwd(K.min):K.min,K._max=at==3?Gs(K.max):at==4?qf(K.max,K.asinh):at==100?K.fwd(K.max):K.max,b[N]=P=!0}}if(P){v.forEach((N,W)=>{s==2?W>0&&b.y&&(N._paths=null):b[N.scale]&&(N._paths=null)});for(let N in b)vt=!0,Ln("setScale",N);gt&&dt.left>=0&&(nt=mt=!0)}for(let N in H)H[N]=null}function kt(y){let b=np(on-1,0,en-1),P=np(an+1,0,en-1);for(;y[b]==null&&b>0;)b--;for(;y[P]==null&&P<en-1;)P++;return[b,P]}function ge(){if(en>0){let y=v.some(b=>b._focus)&&Lt!=zt.alpha;y&&(u.globalAlpha=Lt=zt.alpha),v.forEach((b,P)=>{if(P>0&&b.show&&(je(P,!1),je(P,!0),b._paths==null)){let N=Lt;Lt!=b.alpha&&(u.globalAlpha=Lt=b.alpha);let W=s==2?[0,t[P][0].length-1]:kt(t[P]);b._paths=b.paths(i,P,W[0],W[1]),Lt!=N&&(u.globalAlpha=Lt=N)}}),v.forEach((b,P)=>{if(P>0&&b.show){let N=Lt;Lt!=b.alpha&&(u.globalAlpha=Lt=b.alpha),b._paths!=null&&Le(P,!1);{let W=b._paths!=null?b._paths.gaps:null,K=b.points.show(i,P,on,an,W),at=b.points.filter(i,P,K,W);(K||at)&&(b.points._paths=b.points.paths(i,P,on,an,at),Le(P,!0))}Lt!=N&&(u.globalAlpha=Lt=N),Ln("drawSeries",P)}}),y&&(u.globalAlpha=Lt=1)}}function je(y,b){let P=b?v[y].points:v[y];P._stroke=P.stroke(i,y),P._fill=P.fill(i,y)}function Le(y,b){let P=b?v[y].points:v[y],{stroke:N,fill:W,clip:K,flags:at,_stroke:pt=P._stroke,_fill:St=P._fill,_width:Nt=P.width}=P._paths;Nt=ke(Nt*Te,3);let Ut=null,Bt=Nt%2/2;b&&St==null&&(St=Nt>0?"#fff":pt);let oe=P.pxAlign==1&&Bt>0;if(oe&&u.translate(Bt,Bt),!b){let Ae=R-Nt/2,we=M-Nt/2,_e=X+Nt,jt=ut+Nt;Ut=new Path2D,Ut.rect(Ae,we,_e,jt)}b?Ft(pt,Nt,P.dash,P.cap,St,N,W,at,K):De(y,pt,Nt,P.dash,P.cap,St,N,W,at,Ut,K),oe&&u.translate(-Bt,-Bt)}function De(y,b,P,N,W,K,at,pt,St,Nt,Ut){let Bt=!1;St!=0&&C.forEach((oe,Ae)=>{if(oe.series[0]==y){let we=v[oe.series[1]],_e=t[oe.series[1]],jt=(we._paths||Il).band;yr(jt)&&(jt=oe.dir==1?jt[0]:jt[1]);let Yt,$e=null;we.show&&jt&&fC(_e,on,an)?($e=oe.fill(i,Ae)||K,Yt=we._paths.clip):jt=null,Ft(b,P,N,W,$e,at,pt,St,Nt,Ut,Yt,jt),Bt=!0}}),Bt||Ft(b,P,N,W,K,at,pt,St,Nt,Ut)}let vn=oa|rp;function Ft(y,b,P,N,W,K,at,pt,St,Nt,Ut,Bt){Tt(y,b,P,N,W),(St||Nt||Bt)&&(u.save(),St&&u.clip(St),Nt&&u.clip(Nt)),Bt?(pt&vn)==vn?(u.clip(Bt),Ut&&u.clip(Ut),ve(W,at),hn(y,K,b)):pt&rp?(ve(W,at),u.clip(Bt),hn(y,K,b)):pt&oa&&(u.save(),u.clip(Bt),Ut&&u.clip(Ut),ve(W,at),u.restore(),hn(y,K,b)):(ve(W,at),hn(y,K,b)),(St||Nt||Bt)&&u.restore()}function hn(y,b,P){P>0&&(b instanceof Map?b.forEach((N,W)=>{u.strokeStyle=no=W,u.stroke(N)}):b!=null&&y&&u.stroke(b))}function ve(y,b){b instanceof Map?b.forEach((P,N)=>{u.fillStyle=Xs=N,u.fill(P)}):b!=null&&y&&u.fill(b)}function Es(y,b,P,N){let W=T[y],K;if(N<=0)K=[0,0];else{let at=W._space=W.space(i,y,b,P,N),pt=W._incrs=W.incrs(i,y,b,P,N,at);K=NR(b,P,pt,N,at)}return W._found=K}function un(y,b,P,N,W,K,at,pt,St,Nt){let Ut=at%2/2;_==1&&u.translate(Ut,Ut),Tt(pt,at,St,Nt,pt),u.beginPath();let Bt,oe,Ae,we,_e=W+(N==0||N==3?-K:K);P==0?(oe=W,we=_e):(Bt=W,Ae=_e);for(let jt=0;jt<y.length;jt++)b[jt]!=null&&(P==0?Bt=Ae=y[jt]:oe=we=y[jt],u.moveTo(Bt,oe),u.lineTo(Ae,we));u.stroke(),_==1&&u.translate(-Ut,-Ut)}function so(y){let b=!0;return T.forEach((P,N)=>{if(!P.show)return;let W=S[P.scale];if(W.min==null){P._show&&(b=!1,P._show=!1,de(!1));return}else P._show||(b=!1,P._show=!0,de(!1));let K=P.side,at=K%2,{min:pt,max:St}=W,[Nt,Ut]=Es(N,pt,St,at==0?B:Pt);if(Ut==0)return;let Bt=W.distr==2,oe=P._splits=P.splits(i,N,pt,St,Nt,Ut,Bt),Ae=W.distr==2?oe.map(Yt=>di[Yt]):oe,we=W.distr==2?di[oe[1]]-di[oe[0]]:Nt,_e=P._values=P.values(i,P.filter(i,Ae,N,Ut,we),N,Ut,we);P._rotate=K==2?P.rotate(i,_e,N,Ut):0;let jt=P._size;P._size=ki(P.size(i,_e,N,y)),jt!=null&&P._size!=jt&&(b=!1)}),b}function ss(y){let b=!0;return _a.forEach((P,N)=>{let W=P(i,N,ns,y);W!=Gi[N]&&(b=!1),Gi[N]=W}),b}function As(){for(let y=0;y<T.length;y++){let b=T[y];if(!b.show||!b._show)continue;let P=b.side,N=P%2,W,K,at=b.stroke(i,y),pt=P==0||P==3?-1:1,[St,Nt]=b._found;if(b.label!=null){let jn=b.labelGap*pt,mi=An((b._lpos+jn)*Te);Dt(b.labelFont[0],at,"center",P==2?"top":E_),u.save(),N==1?(W=K=0,u.translate(mi,An(M+ut/2)),u.rotate((P==3?-lu:lu)/2)):(W=An(R+X/2),K=mi);let Ar=px(b.label)?b.label(i,y,St,Nt):b.label;u.fillText(Ar,W,K),u.restore()}if(Nt==0)continue;let Ut=S[b.scale],Bt=N==0?X:ut,oe=N==0?R:M,Ae=b._splits,we=Ut.distr==2?Ae.map(jn=>di[jn]):Ae,_e=Ut.distr==2?di[Ae[1]]-di[Ae[0]]:St,jt=b.ticks,Yt=b.border,$e=jt.show?jt.size:0,sn=An($e*Te),Dn=An((b.alignTo==2?b._size-$e-b.gap:b.gap)*Te),Oe=b._rotate*-lu/180,rn=g(b._pos*Te),fi=(sn+Dn)*pt,Kn=rn+fi;K=N==0?Kn:0,W=N==1?Kn:0;let Ri=b.font[0],Hi=b.align==1?ta:b.align==2?Xf:Oe>0?ta:Oe<0?Xf:N==0?"center":P==3?Xf:ta,as=Oe||N==1?"middle":P==2?"top":E_;Dt(Ri,at,Hi,as);let pi=b.font[1]*b.lineGap,Pi=Ae.map(jn=>g(a(jn,Ut,Bt,oe))),Wi=b._values;for(let jn=0;jn<Wi.length;jn++){let mi=Wi[jn];if(mi!=null){N==0?W=Pi[jn]:K=Pi[jn],mi=""+mi;let Ar=mi.indexOf(`
`)==-1?[mi]:mi.split(/\n/gm);for(let Qn=0;Qn<Ar.length;Qn++){let Tm=Ar[Qn];Oe?(u.save(),u.translate(W,K+Qn*pi),u.rotate(Oe),u.fillText(Tm,0,0),u.restore()):u.fillText(Tm,W,K+Qn*pi)}}}jt.show&&un(Pi,jt.filter(i,we,y,Nt,_e),N,P,rn,sn,ke(jt.width*Te,3),jt.stroke(i,y),jt.dash,jt.cap);let ls=b.grid;ls.show&&un(Pi,ls.filter(i,we,y,Nt,_e),N,N==0?2:1,N==0?M:R,N==0?ut:X,ke(ls.width*Te,3),ls.stroke(i,y),ls.dash,ls.cap),Yt.show&&un([rn],[1],N==0?1:0,N==0?1:2,N==1?M:R,N==1?ut:X,ke(Yt.width*Te,3),Yt.stroke(i,y),Yt.dash,Yt.cap)}Ln("drawAxes")}function de(y){v.forEach((b,P)=>{P>0&&(b._paths=null,y&&(s==1?(b.min=null,b.max=null):b.facets.forEach(N=>{N.min=null,N.max=null})))})}let nn=!1,Jn=!1,Ne=[];function dn(){Jn=!1;for(let y=0;y<Ne.length;y++)Ln(...Ne[y]);Ne.length=0}function Wn(){nn||(TC(cm),nn=!0)}function Hl(y,b=!1){nn=!0,Jn=b,y(i),cm(),b&&Ne.length>0&&queueMicrotask(dn)}i.batch=Hl;function cm(){if(ot&&(me(),ot=!1),vt&&(Et(),vt=!1),xt){if(Ze(f,ta,Kt),Ze(f,"top",le),Ze(f,Tl,B),Ze(f,Cl,Pt),Ze(m,ta,Kt),Ze(m,"top",le),Ze(m,Tl,B),Ze(m,Cl,Pt),Ze(d,Tl,tn),Ze(d,Cl,cn),h.width=An(tn*Te),h.height=An(cn*Te),T.forEach(({_el:y,_show:b,_size:P,_pos:N,side:W})=>{if(y!=null)if(b){let K=W===3||W===0?P:0,at=W%2==1;Ze(y,at?"left":"top",N-K),Ze(y,at?"width":"height",P),Ze(y,at?"top":"left",at?le:Kt),Ze(y,at?"height":"width",at?Pt:B),tp(y,Zr)}else Ai(y,Zr)}),no=Xs=io=k=Q=Y=J=At=w=null,Lt=1,Ma(!0),Kt!=wt||le!=Be||B!=Gt||Pt!=qt){de(!1);let y=B/Gt,b=Pt/qt;if(gt&&!nt&&dt.left>=0){dt.left*=y,dt.top*=b,ro&&ys(ro,An(dt.left),0,B,Pt),oo&&ys(oo,0,An(dt.top),B,Pt);for(let P=0;P<he.length;P++){let N=he[P];N!=null&&(He[P]*=y,Zn[P]*=b,ys(N,ki(He[P]),ki(Zn[P]),B,Pt))}}if(Xe.show&&!st&&Xe.left>=0&&Xe.width>0){Xe.left*=y,Xe.width*=y,Xe.top*=b,Xe.height*=b;for(let P in Wu)Ze(co,P,Xe[P])}wt=Kt,Be=le,Gt=B,qt=Pt}Ln("setSize"),xt=!1}tn>0&&cn>0&&(u.clearRect(0,0,h.width,h.height),Ln("drawClear"),E.forEach(y=>y()),Ln("draw")),Xe.show&&st&&(Wl(Xe),st=!1),gt&&nt&&(Er(null,!0,!1),nt=!1),ft.show&&ft.live&&mt&&(Gu(),mt=!1),l||(l=!0,i.status=1,Ln("ready")),Ws=!1,nn=!1}i.redraw=(y,b)=>{vt=b||!1,y!==!1?Ys(A,L.min,L.max):Wn()};function zu(y,b){let P=S[y];if(P.from==null){if(en==0){let N=P.range(i,b.min,b.max,y);b.min=N[0],b.max=N[1]}if(b.min>b.max){let N=b.min;b.min=b.max,b.max=N}if(en>1&&b.min!=null&&b.max!=null&&b.max-b.min<1e-16)return;y==A&&P.distr==2&&en>0&&(b.min=ts(b.min,t[0]),b.max=ts(b.max,t[0]),b.min==b.max&&b.max++),H[y]=b,ot=!0,Wn()}}i.setScale=zu;let ku,Vu,ro,oo,hm,um,ao,lo,dm,fm,We,Ke,$s=!1,Bn=dt.drag,Pn=Bn.x,In=Bn.y;gt&&(dt.x&&(ku=zi(KT,m)),dt.y&&(Vu=zi(jT,m)),L.ori==0?(ro=ku,oo=Vu):(ro=Vu,oo=ku),We=dt.left,Ke=dt.top);let Xe=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),co=Xe.show?zi(JT,Xe.over?m:f):null;function Wl(y,b){if(Xe.show){for(let P in y)Xe[P]=y[P],P in Wu&&Ze(co,P,y[P]);b!==!1&&Ln("setSelect")}}i.setSelect=Wl;function yS(y){if(v[y].show)tt&&tp(ae[y],Zr);else if(tt&&Ai(ae[y],Zr),gt){let P=Rt?he[0]:he[y];P!=null&&ys(P,-10,-10,B,Pt)}}function Ys(y,b,P){zu(y,{min:b,max:P})}function rs(y,b,P,N){b.focus!=null&&wS(y),b.show!=null&&v.forEach((W,K)=>{K>0&&(y==K||y==null)&&(W.show=b.show,yS(K),s==2?(Ys(W.facets[0].scale,null,null),Ys(W.facets[1].scale,null,null)):Ys(W.scale,null,null),Wn())}),P!==!1&&Ln("setSeries",y,b),N&&ba("setSeries",i,y,b)}i.setSeries=rs;function vS(y,b){_n(C[y],b)}function SS(y,b){y.fill=Me(y.fill||null),y.dir=Ee(y.dir,-1),b=b??C.length,C.splice(b,0,y)}function MS(y){y==null?C.length=0:C.splice(y,1)}i.addBand=SS,i.setBand=vS,i.delBand=MS;function bS(y,b){v[y].alpha=b,gt&&he[y]!=null&&(he[y].style.opacity=b),tt&&ae[y]&&(ae[y].style.opacity=b)}let Ts,qs,wr,ho={focus:!0};function wS(y){if(y!=wr){let b=y==null,P=zt.alpha!=1;v.forEach((N,W)=>{if(s==1||W>0){let K=b||W==0||W==y;N._focus=b?null:K,P&&bS(W,K?1:zt.alpha)}}),wr=y,P&&Wn()}}tt&&te&&be(R_,Ct,y=>{dt._lock||(Qt(y),wr!=null&&rs(null,ho,!0,fn.setSeries))});function os(y,b,P){let N=S[b];P&&(y=y/Te-(N.ori==1?le:Kt));let W=B;N.ori==1&&(W=Pt,y=W-y),N.dir==-1&&(y=W-y);let K=N._min,at=N._max,pt=y/W,St=K+(at-K)*pt,Nt=N.distr;return Nt==3?ia(10,St):Nt==4?mC(St,N.asinh):Nt==100?N.bwd(St):St}function ES(y,b){let P=os(y,A,b);return ts(P,t[0],on,an)}i.valToIdx=y=>ts(y,t[0]),i.posToIdx=ES,i.posToVal=os,i.valToPos=(y,b,P)=>S[b].ori==0?r(y,S[b],P?X:B,P?R:0):o(y,S[b],P?ut:Pt,P?M:0),i.setCursor=(y,b,P)=>{We=y.left,Ke=y.top,Er(null,b,P)};function pm(y,b){Ze(co,ta,Xe.left=y),Ze(co,Tl,Xe.width=b)}function mm(y,b){Ze(co,"top",Xe.top=y),Ze(co,Cl,Xe.height=b)}let va=L.ori==0?pm:mm,Sa=L.ori==1?pm:mm;function AS(){if(tt&&ft.live)for(let y=s==2?1:0;y<v.length;y++){if(y==0&&ue)continue;let b=ft.values[y],P=0;for(let N in b)Ht[y][P++].firstChild.nodeValue=b[N]}}function Gu(y,b){if(y!=null&&(y.idxs?y.idxs.forEach((P,N)=>{et[N]=P}):yC(y.idx)||et.fill(y.idx),ft.idx=et[0]),tt&&ft.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ue)&&TS(P,et[P]);AS()}mt=!1,b!==!1&&Ln("setLegend")}i.setLegend=Gu;function TS(y,b){let P=v[y],N=y==0&&z==2?di:t[y],W;ue?W=P.values(i,y,b)??re:(W=P.value(i,b==null?null:N[b],y,b),W=W==null?re:{_:W}),ft.values[y]=W}function Er(y,b,P){dm=We,fm=Ke,[We,Ke]=dt.move(i,We,Ke),dt.left=We,dt.top=Ke,gt&&(ro&&ys(ro,An(We),0,B,Pt),oo&&ys(oo,0,An(Ke),B,Pt));let N,W=on>an;Ts=ze,qs=null;let K=L.ori==0?B:Pt,at=L.ori==1?B:Pt;if(We<0||en==0||W){N=dt.idx=null;for(let pt=0;pt<v.length;pt++){let St=he[pt];St!=null&&ys(St,-10,-10,B,Pt)}te&&rs(null,ho,!0,y==null&&fn.setSeries),ft.live&&(et.fill(N),mt=!0)}else{let pt,St,Nt;s==1&&(pt=L.ori==0?We:Ke,St=os(pt,A),N=dt.idx=ts(St,t[0],on,an),Nt=V(t[0][N],L,K,0));let Ut=-10,Bt=-10,oe=0,Ae=0,we=!0,_e="",jt="";for(let Yt=s==2?1:0;Yt<v.length;Yt++){let $e=v[Yt],sn=et[Yt],Dn=sn==null?null:s==1?t[Yt][sn]:t[Yt][1][sn],Oe=dt.dataIdx(i,Yt,N,St),rn=Oe==null?null:s==1?t[Yt][Oe]:t[Yt][1][Oe];if(mt=mt||rn!=Dn||Oe!=sn,et[Yt]=Oe,Yt>0&&$e.show){let fi=Oe==null?-10:Oe==N?Nt:V(s==1?t[0][Oe]:t[Yt][0][Oe],L,K,0),Kn=rn==null?-10:D(rn,s==1?S[$e.scale]:S[$e.facets[1].scale],at,0);if(te&&rn!=null){let Ri=L.ori==1?We:Ke,Hi=Tn(zt.dist(i,Yt,Oe,Kn,Ri));if(Hi<Ts){let as=zt.bias;if(as!=0){let pi=os(Ri,$e.scale),Pi=rn>=0?1:-1,Wi=pi>=0?1:-1;Wi==Pi&&(Wi==1?as==1?rn>=pi:rn<=pi:as==1?rn<=pi:rn>=pi)&&(Ts=Hi,qs=Yt)}else Ts=Hi,qs=Yt}}if(mt||Rt){let Ri,Hi;L.ori==0?(Ri=fi,Hi=Kn):(Ri=Kn,Hi=fi);let as,pi,Pi,Wi,ls,jn,mi=!0,Ar=ht.bbox;if(Ar!=null){mi=!1;let Qn=Ar(i,Yt);Pi=Qn.left,Wi=Qn.top,as=Qn.width,pi=Qn.height}else Pi=Ri,Wi=Hi,as=pi=ht.size(i,Yt);if(jn=ht.fill(i,Yt),ls=ht.stroke(i,Yt),Rt)Yt==qs&&Ts<=zt.prox&&(Ut=Pi,Bt=Wi,oe=as,Ae=pi,we=mi,_e=jn,jt=ls);else{let Qn=he[Yt];Qn!=null&&(He[Yt]=Pi,Zn[Yt]=Wi,O_(Qn,as,pi,mi),N_(Qn,jn,ls),ys(Qn,ki(Pi),ki(Wi),B,Pt))}}}}if(Rt){let Yt=zt.prox,$e=wr==null?Ts<=Yt:Ts>Yt||qs!=wr;if(mt||$e){let sn=he[0];sn!=null&&(He[0]=Ut,Zn[0]=Bt,O_(sn,oe,Ae,we),N_(sn,_e,jt),ys(sn,ki(Ut),ki(Bt),B,Pt))}}}if(Xe.show&&$s)if(y!=null){let[pt,St]=fn.scales,[Nt,Ut]=fn.match,[Bt,oe]=y.cursor.sync.scales,Ae=y.cursor.drag;if(Pn=Ae._x,In=Ae._y,Pn||In){let{left:we,top:_e,width:jt,height:Yt}=y.select,$e=y.scales[Bt].ori,sn=y.posToVal,Dn,Oe,rn,fi,Kn,Ri=pt!=null&&Nt(pt,Bt),Hi=St!=null&&Ut(St,oe);Ri&&Pn?($e==0?(Dn=we,Oe=jt):(Dn=_e,Oe=Yt),rn=S[pt],fi=V(sn(Dn,Bt),rn,K,0),Kn=V(sn(Dn+Oe,Bt),rn,K,0),va(es(fi,Kn),Tn(Kn-fi))):va(0,K),Hi&&In?($e==1?(Dn=we,Oe=jt):(Dn=_e,Oe=Yt),rn=S[St],fi=D(sn(Dn,oe),rn,at,0),Kn=D(sn(Dn+Oe,oe),rn,at,0),Sa(es(fi,Kn),Tn(Kn-fi))):Sa(0,at)}else Xu()}else{let pt=Tn(dm-hm),St=Tn(fm-um);if(L.ori==1){let oe=pt;pt=St,St=oe}Pn=Bn.x&&pt>=Bn.dist,In=Bn.y&&St>=Bn.dist;let Nt=Bn.uni;Nt!=null?Pn&&In&&(Pn=pt>=Nt,In=St>=Nt,!Pn&&!In&&(St>pt?In=!0:Pn=!0)):Bn.x&&Bn.y&&(Pn||In)&&(Pn=In=!0);let Ut,Bt;Pn&&(L.ori==0?(Ut=ao,Bt=We):(Ut=lo,Bt=Ke),va(es(Ut,Bt),Tn(Bt-Ut)),In||Sa(0,at)),In&&(L.ori==1?(Ut=ao,Bt=We):(Ut=lo,Bt=Ke),Sa(es(Ut,Bt),Tn(Bt-Ut)),Pn||va(0,K)),!Pn&&!In&&(va(0,0),Sa(0,0))}if(Bn._x=Pn,Bn._y=In,y==null){if(P){if(Am!=null){let[pt,St]=fn.scales;fn.values[0]=pt!=null?os(L.ori==0?We:Ke,pt):null,fn.values[1]=St!=null?os(L.ori==1?We:Ke,St):null}ba($f,i,We,Ke,B,Pt,N)}if(te){let pt=P&&fn.setSeries,St=zt.prox;wr==null?Ts<=St&&rs(qs,ho,!0,pt):Ts>St?rs(null,ho,!0,pt):qs!=wr&&rs(qs,ho,!0,pt)}}mt&&(ft.idx=N,Gu()),b!==!1&&Ln("setCursor")}let Zs=null;Object.defineProperty(i,"rect",{get(){return Zs==null&&Ma(!1),Zs}});function Ma(y=!1){y?Zs=null:(Zs=m.getBoundingClientRect(),Ln("syncRect",Zs))}function gm(y,b,P,N,W,K,at){dt._lock||$s&&y!=null&&y.movementX==0&&y.movementY==0||(Hu(y,b,P,N,W,K,at,!1,y!=null),y!=null?Er(null,!0,!0):Er(b,!0,!1))}function Hu(y,b,P,N,W,K,at,pt,St){if(Zs==null&&Ma(!1),Qt(y),y!=null)P=y.clientX-Zs.left,N=y.clientY-Zs.top;else{if(P<0||N<0){We=-10,Ke=-10;return}let[Nt,Ut]=fn.scales,Bt=b.cursor.sync,[oe,Ae]=Bt.values,[we,_e]=Bt.scales,[jt,Yt]=fn.match,$e=b.axes[0].side%2==1,sn=L.ori==0?B:Pt,Dn=L.ori==1?B:Pt,Oe=$e?K:W,rn=$e?W:K,fi=$e?N:P,Kn=$e?P:N;if(we!=null?P=jt(Nt,we)?a(oe,S[Nt],sn,0):-10:P=sn*(fi/Oe),_e!=null?N=Yt(Ut,_e)?a(Ae,S[Ut],Dn,0):-10:N=Dn*(Kn/rn),L.ori==1){let Ri=P;P=N,N=Ri}}St&&(b==null||b.cursor.event.type==$f)&&((P<=1||P>=B-1)&&(P=Yr(P,B)),(N<=1||N>=Pt-1)&&(N=Yr(N,Pt))),pt?(hm=P,um=N,[ao,lo]=dt.move(i,P,N)):(We=P,Ke=N)}let Wu={width:0,height:0,left:0,top:0};function Xu(){Wl(Wu,!1)}let _m,xm,ym,vm;function Sm(y,b,P,N,W,K,at){$s=!0,Pn=In=Bn._x=Bn._y=!1,Hu(y,b,P,N,W,K,at,!0,!1),y!=null&&(be(Yf,jf,Mm,!1),ba(T_,i,ao,lo,B,Pt,null));let{left:pt,top:St,width:Nt,height:Ut}=Xe;_m=pt,xm=St,ym=Nt,vm=Ut}function Mm(y,b,P,N,W,K,at){$s=Bn._x=Bn._y=!1,Hu(y,b,P,N,W,K,at,!1,!0);let{left:pt,top:St,width:Nt,height:Ut}=Xe,Bt=Nt>0||Ut>0,oe=_m!=pt||xm!=St||ym!=Nt||vm!=Ut;if(Bt&&oe&&Wl(Xe),Bn.setScale&&Bt&&oe){let Ae=pt,we=Nt,_e=St,jt=Ut;if(L.ori==1&&(Ae=St,we=Ut,_e=pt,jt=Nt),Pn&&Ys(A,os(Ae,A),os(Ae+we,A)),In)for(let Yt in S){let $e=S[Yt];Yt!=A&&$e.from==null&&$e.min!=ze&&Ys(Yt,os(_e+jt,Yt),os(_e,Yt))}Xu()}else dt.lock&&(dt._lock=!dt._lock,Er(b,!0,y!=null));y!=null&&(yn(Yf,jf),ba(Yf,i,We,Ke,B,Pt,null))}function CS(y,b,P,N,W,K,at){if(dt._lock)return;Qt(y);let pt=$s;if($s){let St=!0,Nt=!0,Ut=10,Bt,oe;L.ori==0?(Bt=Pn,oe=In):(Bt=In,oe=Pn),Bt&&oe&&(St=We<=Ut||We>=B-Ut,Nt=Ke<=Ut||Ke>=Pt-Ut),Bt&&St&&(We=We<ao?0:B),oe&&Nt&&(Ke=Ke<lo?0:Pt),Er(null,!0,!0),$s=!1}We=-10,Ke=-10,et.fill(null),Er(null,!0,!0),pt&&($s=pt)}function bm(y,b,P,N,W,K,at){dt._lock||(Qt(y),ya(),Xu(),y!=null&&ba(P_,i,We,Ke,B,Pt,null))}function wm(){T.forEach(UR),F(i.width,i.height,!0)}Jr(cu,na,wm);let uo={};uo.mousedown=Sm,uo.mousemove=gm,uo.mouseup=Mm,uo.dblclick=bm,uo.setSeries=(y,b,P,N)=>{let W=fn.match[2];P=W(i,b,P),P!=-1&&rs(P,N,!0,!1)},gt&&(be(T_,m,Sm),be($f,m,gm),be(C_,m,y=>{Qt(y),Ma(!1)}),be(R_,m,CS),be(P_,m,bm),op.add(i),i.syncRect=Ma);let Xl=i.hooks=n.hooks||{};function Ln(y,b,P){Jn?Ne.push([y,b,P]):y in Xl&&Xl[y].forEach(N=>{N.call(null,i,b,P)})}(n.plugins||[]).forEach(y=>{for(let b in y.hooks)Xl[b]=(Xl[b]||[]).concat(y.hooks[b])});let Em=(y,b,P)=>P,fn=_n({key:null,setSeries:!1,filters:{pub:V_,sub:V_},scales:[A,v[1]?v[1].scale:null],match:[G_,G_,Em],values:[null,null]},dt.sync);fn.match.length==2&&fn.match.push(Em),dt.sync=fn;let Am=fn.key,$u=Bx(Am);function ba(y,b,P,N,W,K,at){fn.filters.pub(y,b,P,N,W,K,at)&&$u.pub(y,b,P,N,W,K,at)}$u.sub(i);function RS(y,b,P,N,W,K,at){fn.filters.sub(y,b,P,N,W,K,at)&&uo[y](null,b,P,N,W,K,at)}i.pub=RS;function PS(){$u.unsub(i),op.delete(i),Rn.clear(),ep(cu,na,wm),c.remove(),Ct?.remove(),Ln("destroy")}i.destroy=PS;function Yu(){Ln("init",n,t),xa(t||n.data,!1),H[A]?zu(A,H[A]):ya(),st=Xe.show&&(Xe.width>0||Xe.height>0),nt=mt=!0,F(n.width,n.height)}return v.forEach(eo),T.forEach(bs),e?e instanceof HTMLElement?(e.appendChild(c),Yu()):e(i,Yu):Yu(),i}kn.assign=_n;kn.fmtNum=fp;kn.rangeNum=hu;kn.rangeLog=fu;kn.rangeAsinh=up;kn.orient=jr;kn.pxRatio=Te;kn.join=AC;kn.fmtDate=mp,kn.tzDate=FC;kn.sync=Bx;{kn.addGap=yR,kn.clipGaps=gu;let n=kn.paths={points:Wx};n.linear=$x,n.stepped=MR,n.bars=bR,n.spline=ER}var Mp=(n,t)=>Xt(n)&&(!t||n>0);function OR(n,{log_x:t,log_y:e}){return n.x.map((s,r)=>({x:s,y:Mp(n.y[r],e)?n.y[r]:null,low:Jx(n.band_low,r,e),high:Jx(n.band_high,r,e),label:n.labels?.[r],hint:n.hints?.[r]})).filter(({x:s})=>Mp(s,t)).sort((s,r)=>s.x-r.x)}var Jx=(n,t,e)=>n&&Mp(n[t],e)?n[t]:null;function FR(n){let t=new Map;for(let e of n){let i=new Map;for(let{x:s}of e)i.set(s,(i.get(s)??0)+1);for(let[s,r]of i)t.set(s,Math.max(r,t.get(s)??0))}return[...t].sort(([e],[i])=>e-i).flatMap(([e,i])=>Array(i).fill(e))}function BR(n,t,e){let i=0;return t.map(s=>i<n.length&&n[i].x===s?n[i++][e]:void 0)}function zR(n,t,e){return(e?["y","low","high"]:["y"]).map(i=>BR(n,t,i))}function Kx(n){let t=n.series.map(o=>OR(o,n)),e=FR(t),i=[e],s=[],r=0;return n.series.forEach((o,a)=>{let l=!!(o.band_low&&o.band_high);i.push(...zR(t[a],e,l)),s.push({series:a,part:"y"},...l?[{series:a,part:"low"},{series:a,part:"high"}]:[]),r+=o.x.length-t[a].filter(({y:c})=>c!==null).length}),{data:i,plan:s,points:t,lost:r}}var kR=28,VR=14,jx=(n,t)=>{let{name:e}=n.series[t.s];return t.label??t.hint?`${e}: ${t.label??t.hint}`:e};function GR(n,t){let e=n.log_y?0:Vr(t.flat().map(({y:i})=>i));return i=>{let s=o=>Ot(o,void 0,e);return i.low!==null&&i.high!==null?`${s(i.y)} (${s(i.low)} to ${s(i.high)})`:s(i.y)}}var HR=(n,t,e)=>[jx(n,t),`${n.x_label??"x"}: ${Ot(t.x)}`,`${n.y_label??"y"}: ${e(t)}`];function WR(n,t,e,i,s){let r=t.slice(0,VR),o=r.map(l=>jh(i[l.s],jx(n,l),s(l),e?.s===l.s)),a=t.length-r.length;return[`${n.x_label??"x"}: ${Ot(t[0].x)}`,...o,...a?[`and ${a} more`]:[]]}function XR(n,t,e,i,s,r,o,a){let c=J0(e,i,f=>Math.hypot(n.valToPos(f.x,"x")-o,n.valToPos(f.y,"y")-a),kR),h=K0(t,e,i);if(!h.length)return c&&{words:HR(t,c,r),at:c};let u=c?c.x:tu(h,n.posToVal(o,"x")),d=Rf(e,i,u);return{words:WR(t,d,c,s,r),at:c??d[0]}}function Qx(n,t,e,i,s){let r=t.over.appendChild(q("span",{class:"ring",hidden:!0})),o=_s(e.series),a=GR(e,i),l=()=>{r.hidden=!0,Oi()},c=(u,d,f)=>{let m=XR(t,e,i,s,o,a,d,f);if(!m)return l();r.hidden=!1,r.style.left=`${t.valToPos(m.at.x,"x")}px`,r.style.top=`${t.valToPos(m.at.y,"y")}px`,Vs(u,m.words)};t.over.addEventListener("pointerleave",l),t.over.addEventListener("pointermove",u=>{let d=t.over.getBoundingClientRect();c(u,u.clientX-d.left,u.clientY-d.top)});let h=-1;n.addEventListener("blur",l),n.addEventListener("keydown",u=>{let d={ArrowLeft:-1,ArrowRight:1}[u.key];if(u.key==="Escape"&&l(),!d)return;u.preventDefault();let f=i.flatMap((T,S)=>s[S]?T.filter(C=>C.y!==null):[]),m=[...new Set(f.map(({x:T})=>T))].sort((T,S)=>T-S);if(!m.length)return;h=Math.min(m.length-1,Math.max(0,h+d));let[_]=Rf(i,s,m[h]),[g,p]=[t.valToPos(_.x,"x"),t.valToPos(_.y,"y")],v=t.over.getBoundingClientRect();c({clientX:v.left+g,clientY:v.top+p},g,p)})}var ty=(n,t)=>n.left<t.right&&t.left<n.right&&n.top<t.bottom&&t.top<n.bottom,ey=([n,t],{width:e,height:i})=>({left:n,top:t,right:n+e,bottom:t+i}),ny=(n,t)=>n.left>=t.left&&n.right<=t.left+t.width&&n.top>=t.top&&n.bottom<=t.top+t.height;function iy(n){let t=[];return n.forEach((e,i)=>{let s=n[i-1];if(!e)return;let r=s?Math.ceil(Math.hypot(e[0]-s[0],e[1]-s[1])/5):0;for(let o=1;o<r;++o)t.push(s.map((a,l)=>a+o/r*(e[l]-a)));t.push(e)}),t}function sy([n,t],e,i,s){let r=.7*e.height;return[[n+r,t-e.height/2],[n-r-e.width,t-e.height/2],[n-e.width/2,t-r-e.height],[n-e.width/2,t+r]].map(o=>ey(o,e)).find(o=>ny(o,i)&&!s.some(a=>ty(o,a)))}function $R(n,t,e,i,s){let r=n==="y"?i.width-e.width:i.height-e.height,o=n==="y"?i.left:i.top,a=[0,1,.5,.25,.75].map(c=>o+s+c*(r-2*s)),l=n==="y"?[t-s-e.height,t+s]:[t+s,t-s-e.width];return a.flatMap(c=>l.map(h=>n==="y"?[c,h]:[h,c]))}function ry({axis:n,at:t},e,i,s,r){let o=.4*e.height,a=l=>(ny(l,i)?0:1e6)+1e3*r.filter(c=>ty(l,c)).length+s.filter(([c,h])=>c>l.left-o&&c<l.right+o&&h>l.top-o&&h<l.bottom+o).length;return $R(n,t,e,i,o).map(l=>ey(l,e)).reduce((l,c)=>a(c)<a(l)?c:l)}var ay=new Set,ly=()=>ay.forEach(n=>n()),xn=n=>getComputedStyle(document.documentElement).getPropertyValue(n.replace(/^var\(|\)$/g,"")).trim(),ha=n=>ay.add(n),cy=()=>document.documentElement.classList.contains("printing");function oy(n){document.documentElement.classList.toggle("printing",n),document.querySelectorAll("details").forEach(t=>{n&&(t.open=!0)}),ly()}function hy(){matchMedia("(prefers-color-scheme: dark)").addEventListener("change",ly),addEventListener("beforeprint",()=>oy(!0)),addEventListener("afterprint",()=>oy(!1))}var YR=12,uy=n=>`${YR*n}px system-ui, sans-serif`,qR=(n,t)=>t.label??(n.x.length===1&&n.style==="points"?n.name:null),dy=(n,t)=>t.map(({x:e,y:i})=>i===null?null:[n.valToPos(e,"x",!0),n.valToPos(i,"y",!0)]);function ZR(n,t,e,i,s){let{left:r,top:o,width:a,height:l}=n.bbox,c={lines:[],texts:[]};for(let{axis:h="y",value:u,label:d}of t){let f=Math.round(n.valToPos(u,h,!0));if(c.lines.push(h==="y"?[r,f,r+a,f]:[f,o,f,o+l]),!d)continue;let m=ry({axis:h,at:f},i(d),n.bbox,e,s);s.push(m),c.texts.push({text:d,place:m,color:"--muted"})}return c}function JR(n,t,e,i,s,r){let o=_s(t.series),a=[];return e.forEach((l,c)=>{if(!i[c])return;let h=dy(n,l);l.forEach((u,d)=>{let f=qR(t.series[c],u);f&&h[d]&&a.push({text:f,at:h[d],color:o[c].color})})}),a.flatMap(({text:l,at:c,color:h})=>{let u=sy(c,s(l),n.bbox,r);return u?(r.push(u),[{text:l,place:u,color:h}]):[]})}function vu(n,t,e,i){let s=devicePixelRatio;n.ctx.save(),n.ctx.font=uy(s);let r=d=>({width:n.ctx.measureText(d).width,height:13*s}),o=e.map((d,f)=>i[f]?dy(n,d):[]),a=4*s,l=o.flat().filter(Boolean).map(([d,f])=>({left:d-a,right:d+a,top:f-a,bottom:f+a})),c=o.flatMap((d,f)=>t.series[f].style==="points"?d.filter(Boolean):iy(d)),h=[],u=ZR(n,t.reference_lines??[],c,r,h);return l.push(...h),u.texts.push(...JR(n,t,e,i,r,l)),n.ctx.restore(),u}function KR(n,{text:t,place:e,color:i},s){let r=(e.top+e.bottom)/2;n.lineWidth=4*s,n.strokeStyle=xn("--page"),n.strokeText(t,e.left,r),n.fillStyle=xn(i),n.fillText(t,e.left,r)}function fy(n,{lines:t,texts:e}){let{ctx:i}=n,s=devicePixelRatio;i.save(),i.setLineDash([5*s,4*s]),i.lineWidth=s,i.strokeStyle=xn("--muted");for(let[r,o,a,l]of t)i.beginPath(),i.moveTo(r,o),i.lineTo(a,l),i.stroke();i.setLineDash([]),i.font=uy(s),i.textAlign="left",i.textBaseline="middle";for(let r of e)KR(i,r,s);i.restore()}var jR=320,py="12px system-ui, sans-serif",QR=1e-4;function tP(n,{series:t,part:e},i,s){let r=n.series[t].style??"lines";return e!=="y"?{stroke:"transparent",width:0,points:{show:!1}}:{label:n.series[t].name,stroke:()=>i(t)+(n.series[t].faint?"a0":""),width:r==="points"?0:n.series[t].faint?1:2,dash:s,paths:r==="points"?()=>null:void 0,points:{show:r==="points"||r==="both",size:8,fill:()=>i(t),stroke:()=>i(t)}}}var eP=(n,t)=>n.flatMap(({series:e,part:i},s)=>i==="high"?[{series:[s+1,s],fill:()=>`${t(e)}33`}]:[]),my=(n,t)=>({label:n,labelSize:26,labelFont:py,font:py,stroke:()=>xn("--ink"),grid:{stroke:()=>xn("--faint"),width:1},ticks:{stroke:()=>xn("--faint")},...t?{splits:nP,filter:(e,i)=>i}:{},values:(e,i)=>t?i.map(s=>Ot(s)):gs(i)});function nP(n,t,e,i){let s=Math.floor(Math.log10(e)),r=Math.ceil(Math.log10(i)),o=Math.ceil((r-s)/9),a=r-s<=2?[1,2,5]:[1],l=[];for(let c=Math.ceil(s/o)*o;c<=r;c+=o)l.push(...a.map(h=>+`${h}e${c}`));return l.filter(c=>c>=e&&c<=i)}function gy(n,t){return(e,i,s)=>{let r=[i,s,...t].filter(a=>Xt(a)&&(!n||a>0)),o=Ei(n?r.map(Math.log10):r,.06,QR);return n?o.map(a=>10**a):o}}function _y(n,t,e,i){let s=_s(n.series),r=a=>xn(s[a].color),o=a=>(n.reference_lines??[]).filter(l=>(l.axis??"y")===a).map(l=>l.value);return{width:i,height:n.height??jR,legend:{show:!1},padding:[12,16,0,0],cursor:{drag:{x:!0,y:!0,uni:20},points:{show:!1}},scales:{x:{time:!1,distr:n.log_x?3:1,range:gy(n.log_x,o("x"))},y:{distr:n.log_y?3:1,range:gy(n.log_y,o("y"))}},axes:[{...my(n.x_label,n.log_x),size:34},{...my(n.y_label,n.log_y),size:64}],series:[{},...t.plan.map(a=>tP(n,a,r,s[a.series].dash))],bands:eP(t.plan,r),hooks:{draw:[a=>fy(a,vu(a,n,t.points,e))]}}}var iP=0,bp=(n,t,e,i,s,r={})=>ct("line",{x1:n,y1:t,x2:e,y2:i,stroke:s,...r});function sP(n,t,{x_label:e,y_label:i}){let s=xn("--ink"),r=xn("--faint"),[o,a]=n.axes.map(({_splits:c,_values:h})=>(c??[]).map((u,d)=>({value:u,text:h[d]}))),l=(c,h)=>ct("text",{style:`fill: ${s}`,...c},h??"");return[...o.flatMap(({value:c,text:h})=>[bp(t.x(c),t.top,t.x(c),t.bottom,r),l({x:t.x(c),y:t.bottom+18,"text-anchor":"middle"},h)]),...a.flatMap(({value:c,text:h})=>[bp(t.left,t.y(c),t.right,t.y(c),r),l({x:t.left-8,y:t.y(c)+4,"text-anchor":"end"},h)]),l({x:(t.left+t.right)/2,y:t.bottom+46,"text-anchor":"middle"},e),l({"text-anchor":"middle",transform:`translate(14 ${(t.top+t.bottom)/2}) rotate(-90)`},i)]}function rP({style:n="lines",faint:t},e,{color:i,dash:s},r){let o=xn(i),a=h=>xr(e.map(u=>[r.x(u.x),u[h]===null?NaN:r.y(u[h])])),l=e.filter(({low:h,high:u})=>h!==null&&u!==null),c=h=>l.map(u=>`${r.x(u.x).toFixed(1)} ${r.y(u[h]).toFixed(1)}`);return[l.length>1?ct("path",{fill:o,"fill-opacity":.2,d:`M${[...c("low"),...c("high").reverse()].join("L")}Z`}):null,n==="points"?null:ct("path",{fill:"none",stroke:o,"stroke-width":t?1:2,"stroke-opacity":t?.63:1,"stroke-dasharray":s?.join(" "),d:a("y")}),...n==="lines"?[]:e.filter(({y:h})=>h!==null).map(h=>ct("circle",{fill:o,cx:r.x(h.x),cy:r.y(h.y),r:4}))]}function xy(n,t,e,i){let s=devicePixelRatio,{left:r,top:o,width:a,height:l}=n.bbox,c={left:r/s,top:o/s,right:(r+a)/s,bottom:(o+l)/s,x:m=>n.valToPos(m,"x",!0)/s,y:m=>n.valToPos(m,"y",!0)/s},h=_s(t.series),u=vu(n,t,e,i),d=xn("--muted"),f=`chart-clip-${++iP}`;return ct("svg",{class:"plot",width:n.width,height:n.height,viewBox:`0 0 ${n.width} ${n.height}`},ct("clipPath",{id:f},ct("rect",{x:c.left,y:c.top,width:a/s,height:l/s})),...sP(n,c,t),ct("g",{"clip-path":`url(#${f})`},...t.series.flatMap((m,_)=>i[_]?rP(m,e[_],h[_],c):[])),...u.lines.map(m=>bp(...m.map(_=>_/s),d,{"stroke-dasharray":"5 4"})),...u.texts.map(({text:m,place:_,color:g})=>ct("text",{style:`fill: ${xn(g)}`,x:_.left/s,y:(_.top+_.bottom)/2/s+4},m)))}function yy(n,t){let e=()=>{removeEventListener("beforeprint",e),i.disconnect(),n()},i=t(e);addEventListener("beforeprint",e)}var Su=(n,t)=>yy(t,e=>{let i=new ResizeObserver(()=>n.clientWidth&&e());return i.observe(n),i}),vy=(n,t,e)=>yy(e,i=>{let s=new IntersectionObserver(r=>r.some(({isIntersecting:o})=>o)&&i(),{rootMargin:t});return s.observe(n),s});function oP(n){let t=_s(n.series),e=n.series.map(({name:i,style:s,band_low:r,faint:o},a)=>({name:i,...t[a],mark:s==="points"?"dot":o&&r?"box":"line"}));return e.filter(({name:i},s)=>e.findIndex(r=>r.name===i)===s)}function aP(n,t,e,i){let s=_y(t,e,i,n.clientWidth),r=new kn(s,e.data,n);return t.series.forEach((o,a)=>i[a]||Sy(r,e,a,!1)),Qx(n,r,t,e.points,i),new ResizeObserver(()=>{let o=n.clientWidth;o&&o!==r.width&&r.setSize({width:o,height:r.height})}).observe(n),ha(()=>r.redraw(!1,!0)),n.toSvg=()=>xy(r,t,e.points,i),r}var Sy=(n,t,e,i)=>t.plan.forEach((s,r)=>s.series===e&&n.setSeries(r+1,{show:i}));function lP(n,t){let e=n.log_x||n.log_y?" or not positive on a logarithmic axis":"";return t?`Not shown (n/a): ${t} of the points, without a value${e}.`:""}function My(n){let t=Kx(n),e=n.series.map(()=>!0),i=q("div",{class:"chart",role:"img",tabindex:0,"aria-label":`${n.caption??"Chart"}: ${n.y_label} over ${n.x_label}; arrow keys tell values`}),s=null;Su(i,()=>{s=aP(i,n,t,e)});let r=(o,a)=>n.series.forEach((l,c)=>{l.name===o&&(e[c]=a,s&&Sy(s,t,c,a))});return pn("figure",n.caption,gr(oP(n),r),i,Js(lP(n,t.lost)))}var cP=/^[\w-]+\.html$/,Dl=n=>typeof n=="string"&&cP.test(n),hP=[["asked","Asked."],["done","Done."],["learnt","Learnt."]];function by(n){let t=hP.filter(([i])=>n?.[i]);if(!t.length)return null;let e=t.flatMap(([i,s])=>[q("strong",{},s),` ${String(n[i]).trim()} `]);return q("div",{class:"prose opening"},q("p",{},...e))}var uP=({file:n,link:t})=>Dl(n)?q("a",{href:n},t??"Details"):null;function wy(n){if(!n?.length)return null;let t=n.map(e=>q("li",{},`${e.text} `,uP(e)));return q("div",{class:"summary",role:"region","aria-label":"Summary"},q("h2",{},"Summary"),q("ol",{},...t))}function Ey(n,t){let e=(n??[]).filter(s=>Dl(s.file));if(e.length<2)return null;let i=e.map(s=>q("li",{},q("a",{href:s.file,"aria-current":s.file===t?"page":null},s.title??s.file)));return q("div",{class:"page-list"},q("p",{},"Pages"),q("ol",{},...i))}function Ay(n,t){let e=(n??[]).filter(r=>Dl(r.file)),i=e.findIndex(r=>r.file===t);if(i<0||e.length<2)return null;let s=(r,o,a)=>r?q("a",{href:r.file},`${o}${r.title??r.file}${a}`):q("span");return q("nav",{class:"neighbours","aria-label":"Pages before and after"},s(e[i-1],"\u2190 ",""),s(e[i+1],""," \u2192"))}var Mu=17,dP=24,Ty=26,fP=40,pP=620,wp=({measured:n,low:t,high:e})=>[n,t,e].every(Xt)?n<t||n>e:null;function mP(n,t){let e=n.groups.flatMap(i=>i.rows.flatMap(({values:s})=>[s[t].measured,s[t].low,s[t].high]));return Ei([0,...e.filter(Xt)],.04)}function gP(n,t,e){let i=(r,o,a)=>Xt(o)&&Xt(a)?ct("line",{class:r,x1:t(o),x2:t(a),y1:e,y2:e}):null,s=Xt(n.measured)?ct("circle",{class:wp(n)?"measured-dot out":"measured-dot",cx:t(n.measured),cy:e,r:wp(n)?4.2:3.2}):null;return[i("outer",n.low,n.high),i("inner",n.inner_low,n.inner_high),s]}function _P(n,t,e,i){let s=e.values[i],r=n.unit??"";return[`${e.name}, ${t.name}, ${n.components[i]}`,`measured ${Ot(s.measured)} ${r}${wp(s)?", outside 95 %":""}`,`predicted ${Ot(s.median)} ${r}`,`50 %: ${Ot(s.inner_low)} to ${Ot(s.inner_high)}`,`95 %: ${Ot(s.low)} to ${Ot(s.high)}`]}function Cy(n,t,e,i){let s=i||8,r=e-10,o=mP(n,t),a=gn(o,[s,r]),l=Ty,c=n.groups.flatMap(f=>{l+=dP;let m=ct("text",{class:"title",x:i?0:s,y:l-7},i?f.name:""),_=f.rows.map(g=>{let p=l+Mu/2;return l+=Mu,Fi(ct("g",{class:"predictive-row",role:"img"},ct("rect",{class:"catch",x:0,y:p-Mu/2,width:e,height:Mu}),i?ct("text",{class:"name",x:s-8,y:p+4,"text-anchor":"end"},g.name):null,...gP(g.values[t],a,p)),_P(n,f,g,t))});return[m,..._]}),h={width:e,height:l+fP},u=si(...o,Math.max(2,Math.floor((r-s)/60))),d=`${n.components[t]}${n.unit?` [${n.unit}]`:""}`;return Wr(h,`Measured and predicted ${d}`,ct("text",{class:"title",x:(s+r)/2,y:16,"text-anchor":"middle"},d),...Ko(a,u,Ty,l,"",0),...c)}function xP(n,t){let e=Math.max(...n.groups.flatMap(o=>[...o.rows.map(a=>Gr(a.name)),40])),i=Math.min(180,e)+16,s=n.components.length;if(t<pP)return n.components.map((o,a)=>Cy(n,a,t,i));let r=Math.floor((t-i)/s);return n.components.map((o,a)=>Cy(n,a,a?r:r+i,a?0:i))}var yP=[{name:"measured",color:"var(--ink)",mark:"dot"},{name:"measured, outside 95 %",color:"var(--vermillion)",mark:"dot"},{name:"predicted 50 %",color:"var(--blue)",mark:"thick"},{name:"predicted 95 %",color:"var(--blue)",mark:"thin"}],Ry=n=>pn("figure",n.caption,_r(yP),ms({class:"predictive"},t=>xP(n,t)));var vP=n=>{let t=n==null?"":String(n);return/[",\r\n]/.test(t)?`"${t.replace(/"/g,'""')}"`:t};function bu({columns:n,rows:t}){return[n.map(({name:i,unit:s})=>s?`${i} [${s}]`:i),...t].map(i=>i.map(vP).join(",")).join(`\r
`)+`\r
`}var ua=(...n)=>n.map(t=>({name:t})),Ep=(n,t)=>n.map(e=>t[e]??null);function SP({series:n,x_label:t,y_label:e}){let i=n.flatMap(r=>r.x.map((o,a)=>[r.name,o,r.y[a],r.band_low?.[a]??null,r.band_high?.[a]??null,r.labels?.[a]??r.hints?.[a]??null]));return{columns:ua("series",t||"x",e||"y","band_low","band_high","label"),rows:i}}var Py=["series","value","low","high"],MP=({groups:n})=>({columns:ua("group",...Py),rows:n.flatMap(t=>t.values.map(e=>[t.name,...Ep(Py,e)]))}),Iy=["name","unit","estimate","low","high","inner_low","inner_high","prior_low","prior_high","truth","display"],bP=({rows:n})=>({columns:ua(...Iy),rows:n.map(t=>Ep(Iy,t))}),Ly=["measured","predicted","sd","predicted_sd"],wP=({planes:n})=>({columns:ua("plane","panel","group",...Ly.flatMap(t=>[`${t}_x`,`${t}_y`])),rows:n.flatMap(t=>t.panels.flatMap(e=>e.arrows.map(i=>[t.name,e.title,i.group,...Ly.flatMap(s=>i[s]??[null,null])])))}),Dy=["measured","median","inner_low","inner_high","low","high"],EP=({components:n,groups:t})=>({columns:ua("group","row","component",...Dy),rows:t.flatMap(e=>e.rows.flatMap(i=>i.values.map((s,r)=>[e.name,i.name,n[r],...Ep(Dy,s)])))}),AP=({chains:n,draws:t,quantities:e})=>({columns:ua("quantity","unit","chain","draw","value"),rows:e.flatMap(i=>i.traces.flatMap((s,r)=>s.map((o,a)=>[i.name,i.unit??null,n[r],t[a],o])))}),TP=({quantities:n})=>({columns:n.map(({name:t,unit:e})=>({name:t,unit:e})),rows:n[0].draws.map((t,e)=>n.map(i=>i.draws[e]))}),CP={lines:SP,bars:MP,interval:bP,vectors:wP,predictive:EP,chains:AP,corner:TP},Ap=n=>CP[n.type]?.(n)??null,Nl=(n,t)=>(n??"").toLowerCase().split(/[^a-z0-9]+/).filter(Boolean).slice(0,6).join("-")||t;async function RP(n){let t=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"})),e=new Image;e.src=t;try{await e.decode()}finally{URL.revokeObjectURL(t)}return e}async function Ny(n){let t=await RP(n),e=document.createElement("canvas");return e.width=Math.ceil(2*t.naturalWidth),e.height=Math.ceil(2*t.naturalHeight),e.getContext("2d").drawImage(t,0,0,e.width,e.height),new Promise((i,s)=>e.toBlob(r=>r?i(r):s(new Error("no picture")),"image/png"))}var PP=["fill","fill-opacity","fill-rule","stroke","stroke-width","stroke-opacity","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","paint-order","display","font-family","font-size","font-weight","font-style","text-anchor"];function Uy(n,t){let e=getComputedStyle(n);for(let i of PP)t.style.setProperty(i,e.getPropertyValue(i));t.style.removeProperty("color"),t.removeAttribute("class"),[...n.children].forEach((i,s)=>Uy(i,t.children[s]))}function Oy(n,t,e){let i=n.cloneNode(!0);Uy(n,i);let s={x:t.x-e.x,y:t.y-e.y,width:t.width,height:t.height};for(let[r,o]of Object.entries(s))i.setAttribute(r,o);return i}function Fy(n,t,e,i){let s=n.getBoundingClientRect(),{color:r,fontFamily:o,fontSize:a,fontWeight:l}=getComputedStyle(n),c={x:e-i.x,y:s.y+s.height/2+4-i.y,fill:r},h=`font-family: ${o}; font-size: ${a}; font-weight: ${l}`;return ct("text",{...c,style:h},t)}function IP(n,t,e){if(n instanceof SVGElement)return Oy(n,t,e);let i=getComputedStyle(n).getPropertyValue("--swatch").trim(),[s,r]=[t.x-e.x,t.y-e.y],o=r+t.height/2;return n.matches(".dash, .thin, .thick")?ct("line",{x1:s,x2:s+t.width,y1:o,y2:o,stroke:i,"stroke-width":n.matches(".thick")?6:2.5,"stroke-opacity":n.matches(".thick")?.55:1,"stroke-dasharray":n.matches(".dash")?"5 4":null}):n.matches(".dot, .ring")?ct("circle",{cx:s+t.width/2,cy:o,r:t.width/2-1,stroke:i,fill:n.matches(".ring")?"none":i,"stroke-width":2}):ct("rect",{x:s,y:r,width:t.width,height:t.height,rx:2,fill:i})}function LP(n,t){let e=n.firstElementChild,i=e.getBoundingClientRect(),{opacity:s}=getComputedStyle(n),r=Fy(n,n.textContent,i.right+6,t);return ct("g",{opacity:s},IP(e,i,t),r)}function DP(n,t){let e=[...n.querySelectorAll(".plane > h3")].map(s=>[s,s.textContent]),i=[...n.querySelectorAll(".chooser select")].map(s=>[s,s.selectedOptions[0]?.textContent??""]);return[...e,...i].map(([s,r])=>Fy(s,r,s.getBoundingClientRect().left,t))}function NP(n){let t=getComputedStyle(document.documentElement);for(let e of n.querySelectorAll("[fill^='var('], [stroke^='var(']"))for(let i of["fill","stroke"]){let s=e.getAttribute(i)?.match(/^var\((--[\w-]+)\)$/)?.[1];s&&e.setAttribute(i,t.getPropertyValue(s).trim())}return n}function Tp(n){let t=[...n.querySelectorAll(".chart")].filter(_=>_.toSvg),e=t.map(_=>_.getBoundingClientRect()),i=t.map(_=>_.appendChild(_.toSvg())),s=new Map(i.map((_,g)=>[_,e[g]])),r=[...n.querySelectorAll("svg.plot")].filter(_=>!_.closest("button")),o=[...n.querySelectorAll(".legend > *")],a=_=>s.get(_)??_.getBoundingClientRect(),l=n.querySelectorAll(".plane > h3, .chooser select"),c=[...r,...o,...l].map(a),h={x:Math.min(...c.map(_=>_.left))-8,y:Math.min(...c.map(_=>_.top))-8},u=Math.max(...c.map(_=>_.right))+8-h.x,d=Math.max(...c.map(_=>_.bottom))+8-h.y,f=getComputedStyle(document.documentElement).getPropertyValue("--page").trim(),m=ct("svg",{xmlns:"http://www.w3.org/2000/svg",width:u,height:d,viewBox:`0 0 ${u} ${d}`},ct("rect",{width:u,height:d,fill:f}),...DP(n,h),...o.map(_=>LP(_,h)),...r.map(_=>Oy(_,a(_),h)));return i.forEach(_=>_.remove()),new XMLSerializer().serializeToString(NP(m))}var By=()=>typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported("video/webm");function zy(n,t){let e=document.createElement("canvas");e.width=n.width,e.height=n.height;let i=e.getContext("2d"),s=()=>{i.fillStyle=t,i.fillRect(0,0,e.width,e.height),i.drawImage(n,0,0,e.width,e.height)};s();let r={mimeType:"video/webm",videoBitsPerSecond:8e6},o=new MediaRecorder(e.captureStream(30),r),a=[];o.addEventListener("dataavailable",({data:h})=>a.push(h));let l=new Promise((h,u)=>{o.addEventListener("error",({error:d})=>u(d??new Error("no film"))),o.addEventListener("stop",()=>h(new Blob(a,{type:"video/webm"})))});return l.catch(()=>{}),o.start(),{frame:s,stop:()=>{o.state!=="inactive"&&o.stop()},film:l}}function Qr(n,t,e){let i=URL.createObjectURL(t instanceof Blob?t:new Blob([t],{type:e}));q("a",{href:i,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e3)}var Ul=(n,t,e)=>q("button",{type:"button",title:`Save ${t}`,onclick:e},n);function UP(n,t){let e=Nl(n.caption,n.type),i=()=>Qr(`${e}.svg`,Tp(t),"image/svg+xml"),s=async()=>Qr(`${e}.png`,await Ny(Tp(t))),r=()=>Qr(`${e}.csv`,bu(Ap(n)),"text/csv");return[Ul("SVG","the figure as a drawing",i),Ul("PNG","the figure as a picture",s),Ul("CSV","the numbers of the figure",r)]}function OP(n,t){let e=q("output",{}),i=Ul("WebM","the motion as a film, while it plays once",async()=>{i.disabled=!0,e.textContent="";try{let s=await n.toMovie?.();s&&Qr(`${t}.webm`,s)}catch(s){e.textContent=`No film was saved: ${s.message}`}finally{i.disabled=!1}});return[i,e]}function FP(n,t){let e=t.querySelector(".scene"),i=Nl(n.caption,"scene"),r=[Ul("PNG","the picture as it stands",()=>e.toPng?.(o=>Qr(`${i}.png`,o)))];return n.strip&&By()&&r.push(...OP(e,i)),r}function ky(n,t){let e=n.type==="scene"?FP(n,t):Ap(n)?UP(n,t):[];return e.length&&t.append(q("div",{class:"tools save",role:"group","aria-label":"Save"},...e)),t}var Ol=["#4c02a1","#7e03a8","#a82296","#cb4679","#e56b5d","#f89441","#fdc328"],Rp=n=>[1,3,5].map(t=>parseInt(n.slice(t,t+2),16));function Vy(n){let t=Math.min(1,Math.max(0,n))*(Ol.length-1),e=Math.min(Math.floor(t),Ol.length-2),[i,s]=[Rp(Ol[e]),Rp(Ol[e+1])];return`#${i.map((o,a)=>Math.round(o+(t-e)*(s[a]-o))).map(o=>o.toString(16).padStart(2,"0")).join("")}`}var Pp=(n,{low:t,high:e})=>Vy(e>t?(n-t)/(e-t):0),Gy=()=>`linear-gradient(to right, ${Ol.join(", ")})`;function Hy(n,t){if(!t)return n;let e=i=>Number.isFinite(i.value)?{color:Pp(i.value,t),...i}:i;return n.map(i=>({...i,items:i.items.map(e)}))}var Cp=600,BP=12;function Wy(n,{low:t,high:e}){let i={apart:1/0};for(let s=0;s<=Cp;++s){let r=Rp(Vy(s/Cp)),o=Math.max(...r.map((a,l)=>Math.abs(a-n[l])));o<i.apart&&(i={apart:o,fraction:s/Cp})}return i.apart<=BP?t+i.fraction*(e-t):null}var zP=/^(\d+(?:\.\d+)?(?:e[-+]?\d+)?) s$/;function kP({name:n,time:t}){if(Number.isFinite(t))return t;let e=zP.exec(n);return e?Number(e[1]):null}function Xy(n){let t=n.map(kP),e=new Set(t.filter(i=>i!==null)).size;return n.map((i,s)=>({...i,time:e<3?null:t[s]}))}var wu=n=>[...new Set(n.map(({time:t})=>t).filter(t=>t!==null))].sort((t,e)=>t-e),Eu=(n,t)=>n.findLast(e=>e<=t)??n[0],Ip=[1,.5,.25,.1,.05];function $y(n,t=3){let e=n.at(-1)-n[0],i=Ip.find(s=>e/s>=t)??Ip.at(-1);return{speeds:Ip,chosen:i}}var Yy=1.12;function Lp(n){let t=Math.abs(n.x)<.9?new U(1,0,0):new U(0,1,0);return t.addScaledVector(n,-t.dot(n)).normalize(),new U().crossVectors(t,n).multiplyScalar(1).addScaledVector(t,.7).addScaledVector(n,.6).normalize()}function qy(n){let t=new Nr(-1,1,1,-1,.1,10);return t.up.copy(n),t}var VP=({min:n,max:t})=>[0,1,2,3,4,5,6,7].map(e=>new U(e&1?t.x:n.x,e&2?t.y:n.y,e&4?t.z:n.z));function GP(n,t,e){let i=new U,s=new U;n.matrixWorld.extractBasis(i,s,new U);let r=o=>Math.max(...VP(t).map(a=>Math.abs(a.sub(e).dot(o))));return{x:r(i),y:r(s)}}function Au(n,t){let e=n.userData.half??{x:1,y:1},i=Math.max(e.y,e.x/t);Object.assign(n,{left:-i*t,right:i*t,top:i,bottom:-i}),n.updateProjectionMatrix()}function Dp(n,t,e,i){let s=t.isEmpty()?new Sn(new U(-1,-1,-1),new U(1,1,1)):t,r=s.getCenter(new U),o=s.getSize(new U).length()/2||1;n.position.copy(r).addScaledVector(i??Lp(n.up),4*o),n.near=.01*o,n.far=20*o,n.zoom=1,n.lookAt(r),n.updateMatrixWorld();let a=GP(n,s,r);return n.userData.half={x:Yy*a.x,y:Yy*a.y},Au(n,e),r}var Zy={type:"change"},Up={type:"start"},Ky={type:"end"},Tu=new nr,Jy=new yi,HP=Math.cos(70*Yo.DEG2RAD),Cn=new U,ui=2*Math.PI,Ce={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Np=1e-6,Cu=class extends al{constructor(t,e=null){super(t,e),this.state=Ce.NONE,this.target=new U,this.cursor=new U,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ur.ROTATE,MIDDLE:ur.DOLLY,RIGHT:ur.PAN},this.touches={ONE:dr.ROTATE,TWO:dr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new U,this._lastQuaternion=new Si,this._lastTargetPosition=new U,this._quat=new Si().setFromUnitVectors(t.up,new U(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Go,this._sphericalDelta=new Go,this._scale=1,this._panOffset=new U,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new U,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=XP.bind(this),this._onPointerDown=WP.bind(this),this._onPointerUp=$P.bind(this),this._onContextMenu=QP.bind(this),this._onMouseWheel=ZP.bind(this),this._onKeyDown=JP.bind(this),this._onTouchStart=KP.bind(this),this._onTouchMove=jP.bind(this),this._onMouseDown=YP.bind(this),this._onMouseMove=qP.bind(this),this._interceptControlDown=tI.bind(this),this._interceptControlUp=eI.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ce.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Zy),this.update(),this.state=Ce.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Cn.copy(e).sub(this.target),Cn.applyQuaternion(this._quat),this._spherical.setFromVector3(Cn),this.autoRotate&&this.state===Ce.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ui:i>Math.PI&&(i-=ui),s<-Math.PI?s+=ui:s>Math.PI&&(s-=ui),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Cn.setFromSpherical(this._spherical),Cn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Cn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Cn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new U(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new U(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Cn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Tu.origin.copy(this.object.position),Tu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Tu.direction))<HP?this.object.lookAt(this.target):(Jy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Tu.intersectPlane(Jy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Np||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Np||this._lastTargetPosition.distanceToSquared(this.target)>Np?(this.dispatchEvent(Zy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ui/60*this.autoRotateSpeed*t:ui/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Cn.setFromMatrixColumn(e,0),Cn.multiplyScalar(-t),this._panOffset.add(Cn)}_panUp(t,e){this.screenSpacePanning===!0?Cn.setFromMatrixColumn(e,1):(Cn.setFromMatrixColumn(e,0),Cn.crossVectors(this.object.up,Cn)),Cn.multiplyScalar(t),this._panOffset.add(Cn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Cn.copy(s).sub(this.target);let r=Cn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ui*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ui*this._rotateDelta.x/e.clientHeight),this._rotateUp(ui*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function WP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function XP(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function $P(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ky),this.state=Ce.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function YP(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ce.DOLLY;break;case ur.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}break;case ur.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ce.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ce.PAN}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(Up)}function qP(n){switch(this.state){case Ce.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ce.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ce.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function ZP(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ce.NONE||(n.preventDefault(),this.dispatchEvent(Up),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Ky))}function JP(n){this.enabled!==!1&&this._handleKeyDown(n)}function KP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case dr.ROTATE:if(this.enableRotate===!1){this.state=Ce.NONE;break}this._handleTouchStartRotate(n),this.state=Ce.TOUCH_ROTATE;break;case dr.PAN:if(this.enablePan===!1){this.state=Ce.NONE;break}this._handleTouchStartPan(n),this.state=Ce.TOUCH_PAN;break;default:this.state=Ce.NONE}break;case 2:switch(this.touches.TWO){case dr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ce.TOUCH_DOLLY_PAN;break;case dr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ce.TOUCH_DOLLY_ROTATE;break;default:this.state=Ce.NONE}break;default:this.state=Ce.NONE}this.state!==Ce.NONE&&this.dispatchEvent(Up)}function jP(n){switch(this._trackPointer(n),this.state){case Ce.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ce.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ce.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ce.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ce.NONE}}function QP(n){this.enabled!==!1&&n.preventDefault()}function tI(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function eI(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function jy(n,t,e){let i=new Cu(n,t);return i.enableDamping=!1,i.enableZoom=!1,t.style.touchAction="pan-y",t.addEventListener("pointerdown",()=>t.focus({preventScroll:!0})),t.addEventListener("focus",()=>{i.enableZoom=!0}),t.addEventListener("blur",()=>{i.enableZoom=!1}),i.addEventListener("change",e),i}var Ru=Math.PI/24,Op=1.15;function Qy(n,t,e){let i={ArrowLeft:()=>n.rotateLeft(Ru),ArrowRight:()=>n.rotateLeft(-Ru),ArrowUp:()=>n.rotateUp(Ru),ArrowDown:()=>n.rotateUp(-Ru),"+":()=>n.dollyOut(Op),"=":()=>n.dollyOut(Op),"-":()=>n.dollyIn(Op),0:e,Home:e};t.addEventListener("keydown",s=>{s.ctrlKey||s.altKey||s.metaKey||!Object.hasOwn(i,s.key)||(s.preventDefault(),i[s.key]())})}var nI=new U(0,1,0);function Fl(n,t,e){return n.position.copy(t).add(e).multiplyScalar(.5),n.quaternion.setFromUnitVectors(nI,e.clone().sub(t).normalize()),n}function tv({a:n,b:t,radius:e},{material:i,size:s}){let r=new U(...n),o=new U(...t),a=new Ge(new Lr(e??.02*s,r.distanceTo(o),8,20),i);return Fl(a,r,o),a.userData.labelAt=a.position.clone(),a}function ev({positions:n,radius:t},{material:e,size:i}){let s=new Wa(new or(t??.008*i,12,8),e,n.length);return n.forEach((r,o)=>s.setMatrixAt(o,new xe().makeTranslation(...r))),s.userData.labelAt=new U(...n[0]??[0,0,0]),s}var iI=.5;function nv({tip:n,axis:t,radius:e},{color:i}){let s=new U(...n),r=s.clone().add(new U(...t)),o=new Zi({color:i,transparent:!0,opacity:iI,side:Fn,depthWrite:!1}),a=s.distanceTo(r),l=Fl(new Ge(new Dr(e,a,28,1,!0),o),r,s);return l.userData.labelAt=s,l}function iv(n,t,e,i,s){let r=t.clone().sub(n),o=r.length(),a=new oi;if(o===0)return a;let l=Math.min(i,.5*o),c=t.clone().addScaledVector(r,-l/o);return a.add(Fl(new Ge(new rr(e,e,o-l,12),s),n,c)),a.add(Fl(new Ge(new Dr(2.6*e,l,16),s),c,t)),a}function sv({from:n,vector:t,radius:e},{material:i,size:s}){let r=new U(...n),o=r.clone().add(new U(...t)),a=iv(r,o,e??.005*s,.035*s,i);return a.userData.labelAt=o,a}function rv({point:n,direction:t,length:e},{material:i,size:s}){let r=new U(...t).normalize().multiplyScalar((e??.2*s)/2),o=new U(...n),a=o.clone().add(r),l=iv(o.clone().sub(r),a,.0035*s,.025*s,i);return l.userData.labelAt=a,l}function ov(n,t=Math.PI/3){let e=n.index?n.toNonIndexed():n,i=e.attributes.position,s=i.count,r;if(i.isBufferAttribute===!0&&i.itemSize===3&&i.normalized===!1)r=i.array;else{r=new Float64Array(s*3);for(let S=0;S<s;S++)r[3*S+0]=i.getX(S),r[3*S+1]=i.getY(S),r[3*S+2]=i.getZ(S)}let o=Math.cos(t),a=(1+1e-10)*100,l=s/3,c=new Float64Array(l*3);for(let S=0;S<l;S++){let C=9*S,A=r[C+0],x=r[C+1],E=r[C+2],O=r[C+3],I=r[C+4],L=r[C+5],z=r[C+6],V=r[C+7],D=r[C+8],H=z-O,$=V-I,G=D-L,lt=A-O,Z=x-I,j=E-L,et=$*j-G*Z,ft=G*lt-H*j,dt=H*Z-$*lt,tt=1/(Math.sqrt(et*et+ft*ft+dt*dt)||1);c[3*S+0]=et*tt,c[3*S+1]=ft*tt,c[3*S+2]=dt*tt}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,m=new Int32Array(d),_=0;for(let S=0;S<s;S++){let C=3*S,A=Math.trunc(r[C+0]*a),x=Math.trunc(r[C+1]*a),E=Math.trunc(r[C+2]*a),O=(Math.imul(A,73856093)^Math.imul(x,19349663)^Math.imul(E,83492791))&f;for(;;){let I=m[O];if(I===0){let z=3*_;u[z+0]=A,u[z+1]=x,u[z+2]=E,m[O]=_+1,h[S]=_++;break}let L=3*(I-1);if(u[L+0]===A&&u[L+1]===x&&u[L+2]===E){h[S]=I-1;break}O=O+1&f}}let g=new Int32Array(_+1);for(let S=0;S<s;S++)g[h[S]+1]++;for(let S=0;S<_;S++)g[S+1]+=g[S];let p=new Int32Array(s),v=g.slice(0,_);for(let S=0;S<l;S++){let C=3*S;p[v[h[C+0]]++]=S,p[v[h[C+1]]++]=S,p[v[h[C+2]]++]=S}let T=new Float32Array(s*3);for(let S=0;S<l;S++){let C=3*S,A=c[C+0],x=c[C+1],E=c[C+2];for(let O=0;O<3;O++){let I=C+O,L=h[I],z=0,V=0,D=0;for(let $=g[L],G=g[L+1];$<G;$++){let lt=3*p[$],Z=c[lt+0],j=c[lt+1],et=c[lt+2];A*Z+x*j+E*et>o&&(z+=Z,V+=j,D+=et)}let H=1/(Math.sqrt(z*z+V*V+D*D)||1);T[3*I+0]=z*H,T[3*I+1]=V*H,T[3*I+2]=D*H}}return e.setAttribute("normal",new Un(T,3,!1)),e}var sI=65536,rI=.62,Bp=n=>Uint8Array.from(atob(n),t=>t.charCodeAt(0)).buffer;function oI(n){let t=new Uint8Array(Bp(n)),e=new Float32Array(t.length),i=new ne;for(let s=0;s<t.length;s+=3)i.setRGB(t[s]/255,t[s+1]/255,t[s+2]/255,"srgb").toArray(e,s);return e}function aI({vertices:n,origin:t,step:e,triangles:i,crease:s,colors:r}){let o=new Int16Array(Bp(n)),a=Float32Array.from(o,(h,u)=>t[u%3]+e*h),l=a.length/3>sI?Uint32Array:Uint16Array,c=new Qe;if(c.setAttribute("position",new Un(a,3)),r&&c.setAttribute("color",new Un(oI(r),3)),c.setIndex(new Un(new l(Bp(i)),1)),s===void 0)c.computeVertexNormals();else return ov(c,s*Math.PI/180);return c}var Fp=new WeakMap;function av(n){return Fp.has(n)||Fp.set(n,aI(n)),Fp.get(n)}function lv({rotation:n,position:t=[0,0,0]}){let[e,i,s]=n??[[1,0,0],[0,1,0],[0,0,1]],[[r,o,a],[l,c,h],[u,d,f]]=[e,i,s],[m,_,g]=t;return new xe().set(r,o,a,m,l,c,h,_,u,d,f,g,0,0,0,1)}function cv(n,t){let e=lv(t),{position:i}=av(t.mesh).attributes,s=new U;for(let r=0;r<i.count;++r)n.expandByPoint(s.fromBufferAttribute(i,r).applyMatrix4(e))}function lI(n,t,e){n.solids??(n.solids=new Map);let i=`${t} ${e}`;return n.solids.has(i)||n.solids.set(i,new ja({color:e?16777215:n.color,vertexColors:e,roughness:rI,transparent:t<1,opacity:t,depthWrite:t===1,side:t<1?Fn:0})),n.solids.get(i)}function hv(n,t){let{mesh:e,opacity:i=1}=n,s=new Ge(av(e),lI(t,i,e.colors!==void 0));return s.applyMatrix4(lv(n)),s.castShadow=s.receiveShadow=!0,s.userData.hull=i<1,s.geometry.computeBoundingSphere(),s.userData.labelAt=s.geometry.boundingSphere.center.clone().applyMatrix4(s.matrix),s}var uv=new Sn,Pu=new U,da=class extends il{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new ye(t,3)),this.setAttribute("uv",new ye(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,i=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),i.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new hr(e,6,1);return this.setAttribute("instanceStart",new Di(i,3,0)),this.setAttribute("instanceEnd",new Di(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let i=new hr(e,6,1);return this.setAttribute("instanceColorStart",new Di(i,3,0)),this.setAttribute("instanceColorEnd",new Di(i,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new Ka(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Sn);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),uv.setFromBufferAttribute(e),this.boundingBox.union(uv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new bi),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Pu.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Pu)),Pu.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Pu));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};It.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Zt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};ii.line={uniforms:gl.merge([It.common,It.fog,It.line]),vertexShader:`
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
		`};var Sr=class extends Ni{constructor(t){super({type:"LineMaterial",uniforms:gl.clone(ii.line.uniforms),vertexShader:ii.line.vertexShader,fragmentShader:ii.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var zp=new Pe,dv=new U,fv=new U,Vn=new Pe,Gn=new Pe,vs=new Pe,kp=new U,Vp=new xe,Hn=new rl,pv=new U,Iu=new Sn,Lu=new bi,Ss=new Pe,Ms,to;function mv(n,t,e){return Ss.set(0,0,-t,1).applyMatrix4(n.projectionMatrix),Ss.multiplyScalar(1/Ss.w),Ss.x=to/e.width,Ss.y=to/e.height,Ss.applyMatrix4(n.projectionMatrixInverse),Ss.multiplyScalar(1/Ss.w),Math.abs(Math.max(Ss.x,Ss.y))}function cI(n,t){let e=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Hn.start.fromBufferAttribute(s,a),Hn.end.fromBufferAttribute(r,a),Hn.applyMatrix4(e);let c=new U,h=new U;Ms.distanceSqToSegment(Hn.start,Hn.end,h,c),h.distanceTo(c)<to*.5&&t.push({point:h,pointOnLine:c,distance:Ms.origin.distanceTo(h),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function hI(n,t,e){let i=t.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,h=Math.min(a.instanceCount,l.count),u=-t.near;Ms.at(1,vs),vs.w=1,vs.applyMatrix4(t.matrixWorldInverse),vs.applyMatrix4(i),vs.multiplyScalar(1/vs.w),vs.x*=r.x/2,vs.y*=r.y/2,vs.z=0,kp.copy(vs),Vp.multiplyMatrices(t.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Vn.fromBufferAttribute(l,d),Gn.fromBufferAttribute(c,d),Vn.w=1,Gn.w=1,Vn.applyMatrix4(Vp),Gn.applyMatrix4(Vp),Vn.z>u&&Gn.z>u)continue;if(Vn.z>u){let T=Vn.z-Gn.z,S=(Vn.z-u)/T;Vn.lerp(Gn,S)}else if(Gn.z>u){let T=Gn.z-Vn.z,S=(Gn.z-u)/T;Gn.lerp(Vn,S)}Vn.applyMatrix4(i),Gn.applyMatrix4(i),Vn.multiplyScalar(1/Vn.w),Gn.multiplyScalar(1/Gn.w),Vn.x*=r.x/2,Vn.y*=r.y/2,Gn.x*=r.x/2,Gn.y*=r.y/2,Hn.start.copy(Vn),Hn.start.z=0,Hn.end.copy(Gn),Hn.end.z=0;let _=Hn.closestPointToPointParameter(kp,!0);Hn.at(_,pv);let g=Yo.lerp(Vn.z,Gn.z,_),p=g>=-1&&g<=1,v=kp.distanceTo(pv)<to*.5;if(p&&v){Hn.start.fromBufferAttribute(l,d),Hn.end.fromBufferAttribute(c,d),Hn.start.applyMatrix4(o),Hn.end.applyMatrix4(o);let T=new U,S=new U;Ms.distanceSqToSegment(Hn.start,Hn.end,S,T),e.push({point:S,pointOnLine:T,distance:Ms.origin.distanceTo(S),object:n,face:null,faceIndex:d,uv:null,uv1:null})}}}var Du=class extends Ge{constructor(t=new da,e=new Sr({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,i=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,l=e.count;o<l;o++,a+=2)dv.fromBufferAttribute(e,o),fv.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+dv.distanceTo(fv);let r=new hr(s,2,1);return t.setAttribute("instanceDistanceStart",new Di(r,1,0)),t.setAttribute("instanceDistanceEnd",new Di(r,1,1)),this}raycast(t,e){let i=this.material.worldUnits,s=t.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;Ms=t.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;to=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Lu.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=to*.5;else{let u=Math.max(s.near,Lu.distanceToPoint(Ms.origin));c=mv(s,u,l.resolution)}if(Lu.radius+=c,Ms.intersectsSphere(Lu)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Iu.copy(a.boundingBox).applyMatrix4(o);let h;if(i)h=to*.5;else{let u=Math.max(s.near,Iu.distanceToPoint(Ms.origin));h=mv(s,u,l.resolution)}Iu.expandByScalar(h),Ms.intersectsBox(Iu)!==!1&&(i?cI(this,e):hI(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(zp),this.material.uniforms.resolution.value.set(zp.z,zp.w))}};var fa=class extends da{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setPositions(i),this}setColors(t){let e=t.length-3,i=new Float32Array(2*e);for(let s=0;s<e;s+=3)i[2*s]=t[s],i[2*s+1]=t[s+1],i[2*s+2]=t[s+2],i[2*s+3]=t[s+3],i[2*s+4]=t[s+4],i[2*s+5]=t[s+5];return super.setColors(i),this}setFromPoints(t){let e=t.length-1,i=new Float32Array(6*e);for(let s=0;s<e;s++)i[6*s]=t[s].x,i[6*s+1]=t[s].y,i[6*s+2]=t[s].z||0,i[6*s+3]=t[s+1].x,i[6*s+4]=t[s+1].y,i[6*s+5]=t[s+1].z||0;return super.setPositions(i),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var Nu=class extends Du{constructor(t=new fa,e=new Sr({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};var uI=.35,dI=.15,fI=2.5;function pI(n,t){let e=new Qe;e.setAttribute("position",new ye(n.flat(),3)),e.setIndex(t.flat());let i=e.toNonIndexed();return i.computeVertexNormals(),i}function gv({vertices:n,faces:t},{color:e}){let i=pI(n,t),s=new oi,r=new Zi({color:e,transparent:!0,opacity:uI,side:Fn,depthWrite:!1});return s.add(new Ge(i,r),new Ir(new qa(i,5),new sr({color:e}))),s.children[0].userData.hull=!0,i.computeBoundingSphere(),s.userData.labelAt=i.boundingSphere?.center??new U,s}function _v({positions:n,dashed:t=!1,width:e=fI},{color:i,size:s}){if(n.length<2)return new oi;let r=new Sr({color:i,linewidth:e*(globalThis.devicePixelRatio??1),dashed:t,dashSize:.015*s,gapSize:.01*s}),o=new Nu(new fa().setPositions(n.flat()),r);return o.computeLineDistances(),o.userData.labelAt=new U(...n[Math.floor(n.length/2)]),o}function xv({positions:n,opacity:t=dI},{color:e}){let i=new Qe;i.setAttribute("position",new ye(n.flat(),3));let s=new sr({color:e,transparent:!0,opacity:t,depthWrite:!1}),r=new Ir(i,s);return r.userData.labelAt=new U(...n[0]??[0,0,0]),r}var mI={segment:tv,axis:rv,arrow:sv,hull:gv,points:ev,line:_v,lines:xv,surface:L0,mesh:hv,cone:nv},Uu=n=>n!==null&&typeof n=="object"?Object.entries(n).every(([t,e])=>t==="label"||Uu(e)):n!==null&&!Number.isNaN(n);function gI(n){let t=new Map;return e=>(t.has(e)||t.set(e,{color:new ne(e),material:new Zi({color:e}),size:n}),t.get(e))}function _I(n,t){let e=new oi,i=[],s=gI(t),r=n.items.filter(Uu);for(let o of r){let a=mI[o.kind](o,s(o.color??n.color));a.userData.item=o,e.add(a),o.label&&i.push({position:a.userData.labelAt,text:o.label})}return e.name=n.name,e.visible=n.visible!==!1,{group:e,labels:i,name:n.name,color:n.color,time:n.time??null,lost:n.items.length-r.length}}var yv=(n,t)=>n.map(e=>_I(e,t));var Gp=(n,t,e)=>n.map((i,s)=>i+e*t[s]);function xI(n){let t=Math.hypot(...n)||1;return n.map(e=>e/t)}function yI(n){return n.kind==="segment"?[n.a,n.b]:n.kind==="arrow"?[n.from,Gp(n.from,n.vector,1)]:n.kind==="cone"?[n.tip,Gp(n.tip,n.axis,1)]:n.kind==="axis"?[-.5,.5].map(t=>Gp(n.point,xI(n.direction),t*(n.length??0))):n.kind==="surface"?[-1,1].map(t=>n.center.map(e=>e+t*I0(n))):n.vertices??n.positions}function vv(n){let t=new Sn,e=new U,i=n.filter(({fit:s})=>s!==!1);for(let s of i.flatMap(r=>r.items).filter(Uu)){if(s.kind==="mesh"){cv(t,s);continue}for(let r of yI(s))t.expandByPoint(e.fromArray(r));if(s.radius&&s.kind==="segment")for(let r of[s.a,s.b])for(let o of[-1,1])t.expandByPoint(e.fromArray(r).addScalar(o*s.radius))}return t}var Sv=n=>n.isEmpty()?1:n.getSize(new U).length()||1;var vI=new U(0,1,0);function Mv(n,t,e){let i=wl(t/12),s=2*Math.ceil(.6*t/i),r=new ol(s*i,s,"#888888","#888888");r.material.transparent=!0,r.material.opacity=.28,r.quaternion.setFromUnitVectors(vI,e);let o=n.isEmpty()?new U:n.getCenter(new U),a=n.isEmpty()?0:n.getSize(new U).multiply(new U(...e.toArray().map(Math.abs))).length()/2;return r.position.copy(o).addScaledVector(e,-a),{grid:r,step:i}}var Mr=class n{constructor(t,e,i,s,r="div"){this.parent=t,this.object=e,this.property=i,this._disabled=!1,this._hidden=!1,this.initialValue=this.getValue(),this.domElement=document.createElement(r),this.domElement.classList.add("lil-controller"),this.domElement.classList.add(s),this.$name=document.createElement("div"),this.$name.classList.add("lil-name"),n.nextNameID=n.nextNameID||0,this.$name.id=`lil-gui-name-${++n.nextNameID}`,this.$widget=document.createElement("div"),this.$widget.classList.add("lil-widget"),this.$disable=this.$widget,this.domElement.appendChild(this.$name),this.domElement.appendChild(this.$widget),this.domElement.addEventListener("keydown",o=>o.stopPropagation()),this.domElement.addEventListener("keyup",o=>o.stopPropagation()),this.parent.children.push(this),this.parent.controllers.push(this),this.parent.$children.appendChild(this.domElement),this._listenCallback=this._listenCallback.bind(this),this.name(i)}name(t){return this._name=t,this.$name.textContent=t,this}onChange(t){return this._onChange=t,this}_callOnChange(){this.parent._callOnChange(this),this._onChange!==void 0&&this._onChange.call(this,this.getValue()),this._changed=!0}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(){this._changed&&(this.parent._callOnFinishChange(this),this._onFinishChange!==void 0&&this._onFinishChange.call(this,this.getValue())),this._changed=!1}reset(){return this.setValue(this.initialValue),this._callOnFinishChange(),this}enable(t=!0){return this.disable(!t)}disable(t=!0){return t===this._disabled?this:(this._disabled=t,this.domElement.classList.toggle("lil-disabled",t),this.$disable.toggleAttribute("disabled",t),this)}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}options(t){let e=this.parent.add(this.object,this.property,t);return e.name(this._name),this.destroy(),e}min(t){return this}max(t){return this}step(t){return this}decimals(t){return this}listen(t=!0){return this._listening=t,this._listenCallbackID!==void 0&&(cancelAnimationFrame(this._listenCallbackID),this._listenCallbackID=void 0),this._listening&&this._listenCallback(),this}_listenCallback(){this._listenCallbackID=requestAnimationFrame(this._listenCallback);let t=this.save();t!==this._listenPrevValue&&this.updateDisplay(),this._listenPrevValue=t}getValue(){return this.object[this.property]}setValue(t){return this.getValue()!==t&&(this.object[this.property]=t,this._callOnChange(),this.updateDisplay()),this}updateDisplay(){return this}load(t){return this.setValue(t),this._callOnFinishChange(),this}save(){return this.getValue()}destroy(){this.listen(!1),this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.controllers.splice(this.parent.controllers.indexOf(this),1),this.parent.$children.removeChild(this.domElement)}},Hp=class extends Mr{constructor(t,e,i){super(t,e,i,"lil-boolean","label"),this.$input=document.createElement("input"),this.$input.setAttribute("type","checkbox"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$widget.appendChild(this.$input),this.$input.addEventListener("change",()=>{this.setValue(this.$input.checked),this._callOnFinishChange()}),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.checked=this.getValue(),this}};function Wp(n){let t,e;return(t=n.match(/(#|0x)?([a-f0-9]{6})/i))?e=t[2]:(t=n.match(/rgb\(\s*(\d*)\s*,\s*(\d*)\s*,\s*(\d*)\s*\)/))?e=parseInt(t[1]).toString(16).padStart(2,0)+parseInt(t[2]).toString(16).padStart(2,0)+parseInt(t[3]).toString(16).padStart(2,0):(t=n.match(/^#?([a-f0-9])([a-f0-9])([a-f0-9])$/i))&&(e=t[1]+t[1]+t[2]+t[2]+t[3]+t[3]),e?"#"+e:!1}var SI={isPrimitive:!0,match:n=>typeof n=="string",fromHexString:Wp,toHexString:Wp},zl={isPrimitive:!0,match:n=>typeof n=="number",fromHexString:n=>parseInt(n.substring(1),16),toHexString:n=>"#"+n.toString(16).padStart(6,0)},MI={isPrimitive:!1,match:n=>Array.isArray(n)||ArrayBuffer.isView(n),fromHexString(n,t,e=1){let i=zl.fromHexString(n);t[0]=(i>>16&255)/255*e,t[1]=(i>>8&255)/255*e,t[2]=(i&255)/255*e},toHexString([n,t,e],i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return zl.toHexString(s)}},bI={isPrimitive:!1,match:n=>Object(n)===n,fromHexString(n,t,e=1){let i=zl.fromHexString(n);t.r=(i>>16&255)/255*e,t.g=(i>>8&255)/255*e,t.b=(i&255)/255*e},toHexString({r:n,g:t,b:e},i=1){i=255/i;let s=n*i<<16^t*i<<8^e*i<<0;return zl.toHexString(s)}},wI=[SI,zl,MI,bI];function EI(n){return wI.find(t=>t.match(n))}var Xp=class extends Mr{constructor(t,e,i,s){super(t,e,i,"lil-color"),this.$input=document.createElement("input"),this.$input.setAttribute("type","color"),this.$input.setAttribute("tabindex",-1),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$text=document.createElement("input"),this.$text.setAttribute("type","text"),this.$text.setAttribute("spellcheck","false"),this.$text.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$display.appendChild(this.$input),this.$widget.appendChild(this.$display),this.$widget.appendChild(this.$text),this._format=EI(this.initialValue),this._rgbScale=s,this._initialValueHexString=this.save(),this._textFocused=!1,this.$input.addEventListener("input",()=>{this._setValueFromHexString(this.$input.value)}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$text.addEventListener("input",()=>{let r=Wp(this.$text.value);r&&this._setValueFromHexString(r)}),this.$text.addEventListener("focus",()=>{this._textFocused=!0,this.$text.select()}),this.$text.addEventListener("blur",()=>{this._textFocused=!1,this.updateDisplay(),this._callOnFinishChange()}),this.$disable=this.$text,this.updateDisplay()}reset(){return this._setValueFromHexString(this._initialValueHexString),this}_setValueFromHexString(t){if(this._format.isPrimitive){let e=this._format.fromHexString(t);this.setValue(e)}else this._format.fromHexString(t,this.getValue(),this._rgbScale),this._callOnChange(),this.updateDisplay()}save(){return this._format.toHexString(this.getValue(),this._rgbScale)}load(t){return this._setValueFromHexString(t),this._callOnFinishChange(),this}updateDisplay(){return this.$input.value=this._format.toHexString(this.getValue(),this._rgbScale),this._textFocused||(this.$text.value=this.$input.value.substring(1)),this.$display.style.backgroundColor=this.$input.value,this}},Bl=class extends Mr{constructor(t,e,i){super(t,e,i,"lil-function"),this.$button=document.createElement("button"),this.$button.appendChild(this.$name),this.$widget.appendChild(this.$button),this.$button.addEventListener("click",s=>{s.preventDefault(),this.getValue().call(this.object),this._callOnChange()}),this.$button.addEventListener("touchstart",()=>{},{passive:!0}),this.$disable=this.$button}},$p=class extends Mr{constructor(t,e,i,s,r,o){super(t,e,i,"lil-number"),this._initInput(),this.min(s),this.max(r);let a=o!==void 0;this.step(a?o:this._getImplicitStep(),a),this.updateDisplay()}decimals(t){return this._decimals=t,this.updateDisplay(),this}min(t){return this._min=t,this._onUpdateMinMax(),this}max(t){return this._max=t,this._onUpdateMinMax(),this}step(t,e=!0){return this._step=t,this._stepExplicit=e,this}updateDisplay(){let t=this.getValue();if(this._hasSlider){let e=(t-this._min)/(this._max-this._min);e=Math.max(0,Math.min(e,1)),this.$fill.style.width=e*100+"%"}return this._inputFocused||(this.$input.value=this._decimals===void 0?t:t.toFixed(this._decimals)),this}_initInput(){this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("aria-labelledby",this.$name.id),window.matchMedia("(pointer: coarse)").matches&&(this.$input.setAttribute("type","number"),this.$input.setAttribute("step","any")),this.$widget.appendChild(this.$input),this.$disable=this.$input;let e=()=>{let v=parseFloat(this.$input.value);isNaN(v)||(this._stepExplicit&&(v=this._snap(v)),this.setValue(this._clamp(v)))},i=v=>{let T=parseFloat(this.$input.value);isNaN(T)||(this._snapClampSetValue(T+v),this.$input.value=this.getValue())},s=v=>{v.key==="Enter"&&this.$input.blur(),v.code==="ArrowUp"&&(v.preventDefault(),i(this._step*this._arrowKeyMultiplier(v))),v.code==="ArrowDown"&&(v.preventDefault(),i(this._step*this._arrowKeyMultiplier(v)*-1))},r=v=>{this._inputFocused&&(v.preventDefault(),i(this._step*this._normalizeMouseWheel(v)))},o=!1,a,l,c,h,u,d=5,f=v=>{a=v.clientX,l=c=v.clientY,o=!0,h=this.getValue(),u=0,window.addEventListener("mousemove",m),window.addEventListener("mouseup",_)},m=v=>{if(o){let T=v.clientX-a,S=v.clientY-l;Math.abs(S)>d?(v.preventDefault(),this.$input.blur(),o=!1,this._setDraggingStyle(!0,"vertical")):Math.abs(T)>d&&_()}if(!o){let T=v.clientY-c;u-=T*this._step*this._arrowKeyMultiplier(v),h+u>this._max?u=this._max-h:h+u<this._min&&(u=this._min-h),this._snapClampSetValue(h+u)}c=v.clientY},_=()=>{this._setDraggingStyle(!1,"vertical"),this._callOnFinishChange(),window.removeEventListener("mousemove",m),window.removeEventListener("mouseup",_)},g=()=>{this._inputFocused=!0},p=()=>{this._inputFocused=!1,this.updateDisplay(),this._callOnFinishChange()};this.$input.addEventListener("input",e),this.$input.addEventListener("keydown",s),this.$input.addEventListener("wheel",r,{passive:!1}),this.$input.addEventListener("mousedown",f),this.$input.addEventListener("focus",g),this.$input.addEventListener("blur",p)}_initSlider(){this._hasSlider=!0,this.$slider=document.createElement("div"),this.$slider.classList.add("lil-slider"),this.$fill=document.createElement("div"),this.$fill.classList.add("lil-fill"),this.$slider.appendChild(this.$fill),this.$widget.insertBefore(this.$slider,this.$input),this.domElement.classList.add("lil-has-slider");let t=(p,v,T,S,C)=>(p-v)/(T-v)*(C-S)+S,e=p=>{let v=this.$slider.getBoundingClientRect(),T=t(p,v.left,v.right,this._min,this._max);this._snapClampSetValue(T)},i=p=>{this._setDraggingStyle(!0),e(p.clientX),window.addEventListener("mousemove",s),window.addEventListener("mouseup",r)},s=p=>{e(p.clientX)},r=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("mousemove",s),window.removeEventListener("mouseup",r)},o=!1,a,l,c=p=>{p.preventDefault(),this._setDraggingStyle(!0),e(p.touches[0].clientX),o=!1},h=p=>{p.touches.length>1||(this._hasScrollBar?(a=p.touches[0].clientX,l=p.touches[0].clientY,o=!0):c(p),window.addEventListener("touchmove",u,{passive:!1}),window.addEventListener("touchend",d))},u=p=>{if(o){let v=p.touches[0].clientX-a,T=p.touches[0].clientY-l;Math.abs(v)>Math.abs(T)?c(p):(window.removeEventListener("touchmove",u),window.removeEventListener("touchend",d))}else p.preventDefault(),e(p.touches[0].clientX)},d=()=>{this._callOnFinishChange(),this._setDraggingStyle(!1),window.removeEventListener("touchmove",u),window.removeEventListener("touchend",d)},f=this._callOnFinishChange.bind(this),m=400,_,g=p=>{if(Math.abs(p.deltaX)<Math.abs(p.deltaY)&&this._hasScrollBar)return;p.preventDefault();let T=this._normalizeMouseWheel(p)*this._step;this._snapClampSetValue(this.getValue()+T),this.$input.value=this.getValue(),clearTimeout(_),_=setTimeout(f,m)};this.$slider.addEventListener("mousedown",i),this.$slider.addEventListener("touchstart",h,{passive:!1}),this.$slider.addEventListener("wheel",g,{passive:!1})}_setDraggingStyle(t,e="horizontal"){this.$slider&&this.$slider.classList.toggle("lil-active",t),document.body.classList.toggle("lil-dragging",t),document.body.classList.toggle(`lil-${e}`,t)}_getImplicitStep(){return this._hasMin&&this._hasMax?(this._max-this._min)/1e3:.1}_onUpdateMinMax(){!this._hasSlider&&this._hasMin&&this._hasMax&&(this._stepExplicit||this.step(this._getImplicitStep(),!1),this._initSlider(),this.updateDisplay())}_normalizeMouseWheel(t){let{deltaX:e,deltaY:i}=t;return Math.floor(t.deltaY)!==t.deltaY&&t.wheelDelta&&(e=0,i=-t.wheelDelta/120,i*=this._stepExplicit?1:10),e+-i}_arrowKeyMultiplier(t){let e=this._stepExplicit?1:10;return t.shiftKey?e*=10:t.altKey&&(e/=10),e}_snap(t){let e=0;return this._hasMin?e=this._min:this._hasMax&&(e=this._max),t-=e,t=Math.round(t/this._step)*this._step,t+=e,t=parseFloat(t.toPrecision(15)),t}_clamp(t){return t<this._min&&(t=this._min),t>this._max&&(t=this._max),t}_snapClampSetValue(t){this.setValue(this._clamp(this._snap(t)))}get _hasScrollBar(){let t=this.parent.root.$children;return t.scrollHeight>t.clientHeight}get _hasMin(){return this._min!==void 0}get _hasMax(){return this._max!==void 0}},Yp=class extends Mr{constructor(t,e,i,s){super(t,e,i,"lil-option"),this.$select=document.createElement("select"),this.$select.setAttribute("aria-labelledby",this.$name.id),this.$display=document.createElement("div"),this.$display.classList.add("lil-display"),this.$select.addEventListener("change",()=>{this.setValue(this._values[this.$select.selectedIndex]),this._callOnFinishChange()}),this.$select.addEventListener("focus",()=>{this.$display.classList.add("lil-focus")}),this.$select.addEventListener("blur",()=>{this.$display.classList.remove("lil-focus")}),this.$widget.appendChild(this.$select),this.$widget.appendChild(this.$display),this.$disable=this.$select,this.options(s)}options(t){return this._values=Array.isArray(t)?t:Object.values(t),this._names=Array.isArray(t)?t:Object.keys(t),this.$select.replaceChildren(),this._names.forEach(e=>{let i=document.createElement("option");i.textContent=e,this.$select.appendChild(i)}),this.updateDisplay(),this}updateDisplay(){let t=this.getValue(),e=this._values.indexOf(t);return this.$select.selectedIndex=e,this.$display.textContent=e===-1?t:this._names[e],this}},qp=class extends Mr{constructor(t,e,i){super(t,e,i,"lil-string"),this.$input=document.createElement("input"),this.$input.setAttribute("type","text"),this.$input.setAttribute("spellcheck","false"),this.$input.setAttribute("aria-labelledby",this.$name.id),this.$input.addEventListener("input",()=>{this.setValue(this.$input.value)}),this.$input.addEventListener("keydown",s=>{s.code==="Enter"&&this.$input.blur()}),this.$input.addEventListener("blur",()=>{this._callOnFinishChange()}),this.$widget.appendChild(this.$input),this.$disable=this.$input,this.updateDisplay()}updateDisplay(){return this.$input.value=this.getValue(),this}},AI=`.lil-gui {
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
}`;function TI(n){let t=document.createElement("style");t.innerHTML=n;let e=document.querySelector("head link[rel=stylesheet], head style");e?document.head.insertBefore(t,e):document.head.appendChild(t)}var bv=!1,Ou=class n{constructor({parent:t,autoPlace:e=t===void 0,container:i,width:s,title:r="Controls",closeFolders:o=!1,injectStyles:a=!0,touchStyles:l=!0}={}){if(this.parent=t,this.root=t?t.root:this,this.children=[],this.controllers=[],this.folders=[],this._closed=!1,this._hidden=!1,this.domElement=document.createElement("div"),this.domElement.classList.add("lil-gui"),this.$title=document.createElement("button"),this.$title.classList.add("lil-title"),this.$title.setAttribute("aria-expanded",!0),this.$title.addEventListener("click",()=>this.openAnimated(this._closed)),this.$title.addEventListener("touchstart",()=>{},{passive:!0}),this.$children=document.createElement("div"),this.$children.classList.add("lil-children"),this.domElement.appendChild(this.$title),this.domElement.appendChild(this.$children),this.title(r),this.parent){this.parent.children.push(this),this.parent.folders.push(this),this.parent.$children.appendChild(this.domElement);return}this.domElement.classList.add("lil-root"),l&&this.domElement.classList.add("lil-allow-touch-styles"),!bv&&a&&(TI(AI),bv=!0),i?i.appendChild(this.domElement):e&&(this.domElement.classList.add("lil-auto-place","autoPlace"),document.body.appendChild(this.domElement)),s&&this.domElement.style.setProperty("--width",s+"px"),this._closeFolders=o}add(t,e,i,s,r){if(Object(i)===i)return new Yp(this,t,e,i);let o=t[e];switch(typeof o){case"number":return new $p(this,t,e,i,s,r);case"boolean":return new Hp(this,t,e);case"string":return new qp(this,t,e);case"function":return new Bl(this,t,e)}console.error(`gui.add failed
	property:`,e,`
	object:`,t,`
	value:`,o)}addColor(t,e,i=1){return new Xp(this,t,e,i)}addFolder(t){let e=new n({parent:this,title:t});return this.root._closeFolders&&e.close(),e}load(t,e=!0){return t.controllers&&this.controllers.forEach(i=>{i instanceof Bl||i._name in t.controllers&&i.load(t.controllers[i._name])}),e&&t.folders&&this.folders.forEach(i=>{i._title in t.folders&&i.load(t.folders[i._title])}),this}save(t=!0){let e={controllers:{},folders:{}};return this.controllers.forEach(i=>{if(!(i instanceof Bl)){if(i._name in e.controllers)throw new Error(`Cannot save GUI with duplicate property "${i._name}"`);e.controllers[i._name]=i.save()}}),t&&this.folders.forEach(i=>{if(i._title in e.folders)throw new Error(`Cannot save GUI with duplicate folder "${i._title}"`);e.folders[i._title]=i.save()}),e}open(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),this.domElement.classList.toggle("lil-closed",this._closed),this}close(){return this.open(!1)}_setClosed(t){this._closed!==t&&(this._closed=t,this._callOnOpenClose(this))}show(t=!0){return this._hidden=!t,this.domElement.style.display=this._hidden?"none":"",this}hide(){return this.show(!1)}openAnimated(t=!0){return this._setClosed(!t),this.$title.setAttribute("aria-expanded",!this._closed),requestAnimationFrame(()=>{let e=this.$children.clientHeight;this.$children.style.height=e+"px",this.domElement.classList.add("lil-transition");let i=r=>{r.target===this.$children&&(this.$children.style.height="",this.domElement.classList.remove("lil-transition"),this.$children.removeEventListener("transitionend",i))};this.$children.addEventListener("transitionend",i);let s=t?this.$children.scrollHeight:0;this.domElement.classList.toggle("lil-closed",!t),requestAnimationFrame(()=>{this.$children.style.height=s+"px"})}),this}title(t){return this._title=t,this.$title.textContent=t,this}reset(t=!0){return(t?this.controllersRecursive():this.controllers).forEach(i=>i.reset()),this}onChange(t){return this._onChange=t,this}_callOnChange(t){this.parent&&this.parent._callOnChange(t),this._onChange!==void 0&&this._onChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onFinishChange(t){return this._onFinishChange=t,this}_callOnFinishChange(t){this.parent&&this.parent._callOnFinishChange(t),this._onFinishChange!==void 0&&this._onFinishChange.call(this,{object:t.object,property:t.property,value:t.getValue(),controller:t})}onOpenClose(t){return this._onOpenClose=t,this}_callOnOpenClose(t){this.parent&&this.parent._callOnOpenClose(t),this._onOpenClose!==void 0&&this._onOpenClose.call(this,t)}destroy(){this.parent&&(this.parent.children.splice(this.parent.children.indexOf(this),1),this.parent.folders.splice(this.parent.folders.indexOf(this),1)),this.domElement.parentElement&&this.domElement.parentElement.removeChild(this.domElement),Array.from(this.children).forEach(t=>t.destroy())}controllersRecursive(){let t=Array.from(this.controllers);return this.folders.forEach(e=>{t=t.concat(e.controllersRecursive())}),t}foldersRecursive(){let t=Array.from(this.folders);return this.folders.forEach(e=>{t=t.concat(e.foldersRecursive())}),t}};var CI=700,RI=400;function PI(n,{group:t,name:e,color:i},s){let r=n.add(t,"visible").name(e).onChange(s);r.domElement.style.setProperty("--layer",i),r.domElement.classList.add("layer")}function II(n){let t=[];for(let{group:e}of n)e.traverse(i=>i.userData.hull&&t.push(i.material));return t}function LI(n,t,e){let i=II(t);if(!i.length)return;let s={"surface opacity":i[0].opacity};n.add(s,"surface opacity",0,1,.05).onChange(r=>{for(let o of i)o.opacity=r;e()})}function wv(n,t){let e=new Ou({container:n,title:"Layers",width:190});for(let i of t.layers)i.time===null&&PI(e,i,t.draw);return LI(e,t.layers,t.draw),t.layers.some(i=>i.labels.length)&&e.add(t.show,"labels").onChange(t.draw),e.add(t.grid,"visible").name("grid").onChange(t.draw),e.add(t,"fit").name("fit view"),n.clientWidth<CI&&e.close(),e.onOpenClose(()=>setTimeout(t.draw,RI)),e}var Zp=1024;function DI(n,{up:t,from:e,center:i,radius:s}){let r=new ko(16777215,1.9),o=new U().crossVectors(t,e),a=e.clone().addScaledVector(t,1.3).addScaledVector(o,-.8).normalize();r.position.copy(i).addScaledVector(a,2*s),r.target.position.copy(i),r.castShadow=!0,r.shadow.mapSize.set(Zp,Zp);let l={left:-s,right:s,top:s,bottom:-s};Object.assign(r.shadow.camera,l,{near:.2*s,far:4*s}),r.shadow.normalBias=4*s/Zp,r.shadow.radius=4,n.add(r,r.target)}function Ev(n,t,e,i){let s=new el(16777215,9080729,i?1.3:1.6);s.position.copy(e);let r=new ko(16777215,i?.7:1.8);r.position.set(-.6,.8,1),t.add(r),n.add(s,t),i&&DI(n,{...i,up:e})}var NI=[0,-1,1,-2,2,-3,3,-4,4],UI=(n,t)=>n.left<t.right&&t.left<n.right&&n.top<t.bottom&&t.top<n.bottom;function OI({x:n,y:t,width:e}){return NI.flatMap(i=>[n+6,n-6-e].map(s=>({left:s,right:s+e,top:t+(i-.5)*14,bottom:t+(i+.5)*14,far:i!==0})))}function Av(n,{width:t,height:e},i=[]){let s=[...i],r=({left:o,right:a,top:l,bottom:c})=>o>=2&&a<=t-2&&l>=1&&c<=e-1;return[...n].sort((o,a)=>o.depth-a.depth).flatMap(o=>{let a=OI(o).find(l=>r(l)&&!s.some(c=>UI(l,c)));return a?(s.push(a),[{label:o,place:a}]):[]})}var Jp="system-ui, sans-serif",FI=[["x","#d55e00",new U(1,0,0)],["y","#009e73",new U(0,1,0)],["z","#0072b2",new U(0,0,1)]];function Kp(n,t,e,i,s,r){n.lineJoin="round",n.lineWidth=3.5,n.strokeStyle=r,n.strokeText(t,e,i),n.fillStyle=s,n.fillText(t,e,i)}function BI(n,t,e,i){let s=n.clone().project(t);return[(s.x+1)/2*e,(1-s.y)/2*i]}var zI=({width:n,height:t,compact:e})=>[{left:n-110,right:n,top:t-36,bottom:t},...e?[]:[{left:0,right:84,top:t-84,bottom:t}]];function Tv(n,t,e,i,s=[]){let{width:r,height:o,ink:a,page:l,muted:c}=i;n.font=`600 12px ${Jp}`,n.textBaseline="middle";let h=t.map(({position:d,text:f})=>{let m=d.clone().project(e),[_,g]=BI(d,e,r,o);return{x:_,y:g,depth:m.z,text:f,width:n.measureText(f).width}}),u=Av(h,i,[...zI(i),...s]);n.strokeStyle=c??a,n.lineWidth=1;for(let{label:d,place:f}of u.filter(m=>m.place.far))n.beginPath(),n.moveTo(d.x,d.y),n.lineTo(f.left>d.x?f.left-2:f.right+2,(f.top+f.bottom)/2),n.stroke();for(let{label:d,place:f}of u)Kp(n,d.text,f.left,(f.top+f.bottom)/2,a,l)}function Cv(n,t,e,{width:i,height:s,ink:r,page:o}){let a=i*t.zoom/(t.right-t.left),l=wl(50/a),c=i-16,h=s-14;n.strokeStyle=r,n.lineWidth=2,n.beginPath();let u=c-l*a;n.moveTo(u,h-4),n.lineTo(u,h),n.lineTo(c,h),n.lineTo(c,h-4),n.stroke(),n.font=`12px ${Jp}`,n.textAlign="center",Kp(n,`${Ot(l)} ${e}`,(u+c)/2,h-10,r,o),n.textAlign="left"}function kI(n,t){let e=n.dot(t);return e>.999?" up":e<-.999?" down":""}function Rv(n,t,{height:e,ink:i,page:s},r=[]){let o=[r.some(Boolean)?64:42,e-40],a=24,l=FI.map(([c,h,u],d)=>({name:(r[d]?`${c} ${r[d]}`:c)+kI(u,t.up),color:h,v:u.clone().transformDirection(t.matrixWorldInverse)}));n.font=`600 11px ${Jp}`,n.textAlign="center",n.textBaseline="middle";for(let{name:c,color:h,v:u}of l.sort((d,f)=>d.v.z-f.v.z)){n.strokeStyle=h,n.lineWidth=2.5,n.beginPath(),n.moveTo(...o),n.lineTo(o[0]+a*u.x,o[1]-a*u.y),n.stroke();let d=a+9,f=n.measureText(c).width/2+3,m=Math.sign(u.x)*Math.max(0,f-9)*Math.min(1,2*Math.abs(u.x)),_=Math.max(f,o[0]+d*u.x+m);Kp(n,c,_,o[1]-d*u.y,i,s)}n.textAlign="left"}var jp=new Map,Qp=!1;function VI(n,t){let e=t.view.camera.position.clone().sub(t.controls.target),i=n.view.camera.position.distanceTo(n.controls.target);n.view.camera.position.copy(n.controls.target).addScaledVector(e.normalize(),i),n.view.camera.zoom=t.view.camera.zoom,n.view.camera.updateProjectionMatrix(),n.controls.update(),n.view.draw()}function Pv(n,t,e){let i=jp.get(n)??[],s={view:t,controls:e};jp.set(n,[...i,s]),e.addEventListener("change",()=>{Qp||(Qp=!0,jp.get(n).filter(r=>r!==s).forEach(r=>VI(r,s)),Qp=!1)})}var Iv=5,GI=.6,HI=n=>n.material?.transparent?n.material.opacity:1;function*tm(n){for(let t=n;t;t=t.parent)yield t}var WI=n=>[...tm(n)].every(({visible:t})=>t),XI=n=>[...tm(n)].find(({userData:t})=>t.item)?.userData.item??null,$I=n=>n.isMesh===!0&&HI(n)>GI,YI=n=>n.find(({object:t})=>$I(t))??n[0];function qI({object:n,face:t,point:e}){let i=n.geometry?.attributes?.color;if(!i||!t||!n.material.vertexColors)return null;let{position:s}=n.geometry.attributes,r=n.worldToLocal(e.clone()),o=[t.a,t.b,t.c],[a,l,c]=o.map(f=>new U().fromBufferAttribute(s,f)),h=l.clone().sub(a).cross(c.clone().sub(a)),u=(f,m)=>f.sub(r).cross(m.sub(r)).dot(h)/h.lengthSq(),d=[u(l.clone(),c.clone()),u(c.clone(),a.clone()),u(a.clone(),l.clone())];return[0,1,2].map(f=>d.reduce((m,_,g)=>m+_*i.getComponent(o[g],f),0))}function Lv({camera:n,layers:t},{x:e,y:i},s){let r=new sl;r.setFromCamera(new Zt(e,i),n);let o=Iv*(n.top-n.bottom)/(2*s*n.zoom);r.params.Line.threshold=o,r.params.Line2={threshold:2*Iv};let a=t.map(({group:d})=>d).filter(({visible:d})=>d);a.forEach(d=>d.updateMatrixWorld());let l=r.intersectObjects(a,!0).filter(({object:d})=>WI(d));if(!l.length)return null;let c=YI(l),h=[...tm(c.object)];return{layer:t.find(({group:d})=>h.includes(d)),item:XI(c.object),point:c.point,color:qI(c)}}var pa=null;function em(){return pa||(pa=new qh({antialias:!0,alpha:!0}),pa.shadowMap.enabled=!0,pa.shadowMap.type=Ur,pa)}function Dv(n,t,e){let{width:i,height:s}=n.canvas,r=em(),o=r.domElement;(o.width!==i||o.height!==s)&&r.setSize(i,s,!1),r.render(t,e),n.clearRect(0,0,i,s),n.drawImage(r.domElement,0,0)}function ZI(n){let t=document.createElement("canvas");return t.tabIndex=0,t.setAttribute("role","img"),t.setAttribute("aria-label",`${n.dataset.label??"3D view"}; arrow keys turn, plus and minus zoom, 0 fits`),n.append(t),t}function JI(n,t,e,i){return!n.some(({items:r})=>r.some(({kind:o})=>o==="mesh"))||t.isEmpty()?null:{from:i,center:t.getCenter(new U),radius:.75*e}}function KI({layers:n,up:t=[0,0,1],view:e}){let i=vv(n),s=Sv(i),r=new U(...t).normalize(),o=new za,a=qy(r),l=yv(n,s),{grid:c}=Mv(i,s,r);c.visible=n.every(({fit:u})=>u!==!1),o.add(c,...l.map(u=>u.group));let h=e?new U(...e).normalize():Lp(r);return Ev(o,a,r,JI(n,i,s,h)),{scene:o,camera:a,box:i,grid:c,layers:l,show:{labels:!0},from:h}}function jI(n){if(!n)return[];let{offsetLeft:t,offsetTop:e,offsetWidth:i,offsetHeight:s}=n.domElement;return[{left:t,top:e,right:t+i,bottom:e+s}]}function Ov(n,t,e,{unit:i="mm",compact:s,axes:r},o,a){let{canvas:l}=t,c={width:l.width/o,height:l.height/o},h={...e(),...c,compact:s};Dv(t,n.scene,n.camera),t.save(),t.scale(o,o);let u=n.layers.filter(d=>d.group.visible).flatMap(d=>d.labels);n.show.labels&&Tv(t,u,n.camera,h,a),s||Rv(t,n.camera,h,r),Cv(t,n.camera,i,h),t.restore()}function Nv(n,t){n.traverse(({material:e})=>{e?.isLineMaterial&&(e.linewidth*=t)})}function Fv(n,t,e,i,s){let r=document.createElement("canvas");r.width=Math.max(1,Math.round(t.width*s)),r.height=Math.max(1,Math.round(t.height*s));let o=r.getContext("2d"),a=s/devicePixelRatio;return Nv(n.scene,a),Au(n.camera,r.width/r.height),Ov(n,o,e,i,s,[]),Nv(n.scene,1/a),o.globalCompositeOperation="destination-over",o.fillStyle=e().page,o.fillRect(0,0,r.width,r.height),r}function QI(n,t,e,i,s){let r=n.camera.clone(!1);return Dp(r,n.box,t.width/t.height,n.from),Fv({...n,camera:r},t,e,{...i,compact:!0},s)}function Uv(n,t){return n.width=Math.max(1,Math.round(t.clientWidth*devicePixelRatio)),n.height=Math.max(1,Math.round(t.clientHeight*devicePixelRatio)),n.width/n.height}function t2(n){let t=!1;return()=>{t||(t=!0,requestAnimationFrame(()=>{t=!1,n()}))}}function Bv(n,t,e){em();let i=ZI(n),s=i.getContext("2d"),r=KI(t),o=()=>Ov(r,s,e,t,devicePixelRatio,jI(r.panel));r.draw=t2(o);let a=()=>({width:n.clientWidth,height:n.clientHeight});r.picture=c=>Fv(r,a(),e,t,c),r.still=(c,h)=>QI(r,c,e,t,h),r.paintNow=o,r.canvas=i,r.at=({clientX:c,clientY:h})=>{let{left:u,top:d,width:f,height:m}=i.getBoundingClientRect(),_={x:2*(c-u)/f-1,y:1-2*(h-d)/m};return Lv(r,_,m/2)};let l=jy(r.camera,i,r.draw);return r.fit=()=>{l.target.copy(Dp(r.camera,r.box,i.width/i.height,r.from)),l.update(),r.draw()},i.addEventListener("dblclick",r.fit),Qy(l,i,r.fit),Uv(i,n),r.fit(),t.compact||(r.panel=wv(n,r)),t.link&&Pv(t.link,r,l),new ResizeObserver(()=>{n.clientWidth&&(Au(r.camera,Uv(i,n)),o())}).observe(n),r.lost=r.layers.reduce((c,h)=>c+h.lost,0),r}var kv=({label:n,low:t,high:e,dashed:i})=>q("div",{class:"color-bar"},q("span",{},n),q("span",{class:"number"},Ot(t)),q("span",{class:"ramp",style:`background: ${Gy()}`}),q("span",{class:"number"},Ot(e)),i?q("span",{class:"dashed"},i):null),zv=30,kl={width:176,height:11},nm=8;function Vv(n,{label:t,low:e,high:i},s,r){let o=document.createElement("canvas");o.width=n.width,o.height=n.height+zv*r;let a=o.getContext("2d");a.fillStyle=s.page,a.fillRect(0,0,o.width,o.height),a.drawImage(n,0,0),a.scale(r,r),a.font="12px system-ui, sans-serif",a.textBaseline="middle";let l=n.height/r+zv/2,c=nm,h=u=>{a.fillStyle=s.ink,a.fillText(u,c,l),c+=a.measureText(u).width+nm};h(t),h(Ot(e));for(let u=0;u<kl.width;++u)a.fillStyle=Pp(u,{low:0,high:kl.width-1}),a.fillRect(c+u,l-kl.height/2,1.5,kl.height);return c+=kl.width+nm,h(Ot(i)),o}var e2=10;function n2(n){let t=null,e=i=>{let s=t===null?0:(i-t)/1e3;t=i,n(s)&&requestAnimationFrame(e)};requestAnimationFrame(e)}function i2(n,t){for(let{group:e,time:i}of n.layers)i!==null&&(e.visible=t===null||i===t);n.draw()}function Gv(n){let t=wu(n.layers);if(!t.length)return null;let[e,i]=[t[0],t.at(-1)],{speeds:s,chosen:r}=$y(t),o=!1,a=0,l=e,c=q("button",{type:"button",class:"play"}),h=q("output",{}),u=q("input",{type:"range",min:0,max:t.length-1,step:1,value:0,"aria-label":"Instant"}),d=q("select",{"aria-label":"Speed"},...s.map(T=>q("option",{value:T,selected:T===r},`${Ot(T)} \xD7`))),f=q("input",{type:"checkbox",checked:t.length<e2}),m=()=>{let T=Eu(t,l);c.textContent=o?"Pause":"\u25B6 Play",u.value=String(t.indexOf(T)),h.textContent=f.checked?"":`${Ot(T)} s`,i2(n,f.checked?null:T)},_=()=>{o=!1,++a},g=(T=()=>{})=>new Promise((S,C)=>{_();let A=a;o=!0,f.checked=!1,l>=i&&(l=e),n2(x=>{if(A===a){l=Math.min(i,l+x*Number(d.value)),l>=i&&_(),m();try{T()}catch(E){_(),C(E)}}return A!==a&&S(),A===a})}),p=async(T,S)=>{let C=[c,u,d,f];_();for(let A of C)A.disabled=!0;try{l=e;let A=zy(T,S);try{await g(()=>{n.paintNow(),A.frame()})}finally{A.stop()}return await A.film}finally{for(let A of C)A.disabled=!1;_(),m()}};return c.addEventListener("click",()=>{o?_():g(),m()}),u.addEventListener("input",()=>{_(),f.checked=!1,l=t[Number(u.value)],m()}),f.addEventListener("change",()=>{_(),m()}),m(),{element:q("div",{class:"tools player",role:"group","aria-label":"Motion"},c,u,h,d,q("label",{},f," all instants")),film:p}}var s2=([n,t,e])=>{let{r:i,g:s,b:r}=new ne(n,t,e).convertLinearToSRGB();return[i,s,r].map(o=>255*o)};function r2({item:n,color:t},e){return e?Number.isFinite(n?.value)?n.value:t?Wy(s2(t),e):null:null}function o2(n,t){let[,e,i]=n.match(/^(.*?)\s*(?:\[([^\]]*)\])?$/);return`${e} ${Ot(Number(t.toPrecision(3)))}${i?` ${i}`:""}`}function a2(n,{color_scale:t,unit:e="mm",axes:i=[]}){let{layer:s,item:r,point:o}=n,a=r2(n,t),l=Math.max(...o.toArray().map(Math.abs)),c=u=>Ot(Number(u.toFixed(l<10?2:1))),h=o.toArray().map((u,d)=>{let f=i[d]?` (${i[d]})`:"";return`${"xyz"[d]}${f} ${c(u)}`});return[r?.label?`${s.name}: ${r.label}`:s.name,...a===null?[]:[o2(t.label,a)],`${h.join(", ")} ${e}`]}function Hv(n,t){let e=null,i=s=>{e=s,requestAnimationFrame(()=>{if(e!==s)return;let r=n.at(s);r?Vs(s,a2(r,t)):Oi()})};n.canvas.addEventListener("pointermove",s=>{s.buttons===0?i(s):Oi()}),n.canvas.addEventListener("pointerleave",()=>{e=null,Oi()})}var l2={width:300,height:225},c2=2;function h2(n,t,e){let i=n.layers.filter(({time:r})=>r!==null),s=i.map(({group:r})=>r.visible);for(let r of t){for(let{group:o,time:a}of i)o.visible=a===r;e(r)}i.forEach(({group:r},o)=>r.visible=s[o])}function Wv(n,t){let e=wu(n.layers);if(!t?.length||!e.length)return null;let i=[...new Set(t.map(o=>Eu(e,o)))],s=q("div",{class:"strip",role:"group","aria-label":"Motion in pictures"}),r=()=>{s.replaceChildren(),h2(n,i,o=>{let a=`${Ot(o)} s`,l=n.still(l2,c2);l.setAttribute("role","img"),l.setAttribute("aria-label",`At ${a}`),s.append(q("div",{class:"still"},l,q("span",{},a)))}),n.draw()};return r(),ha(r),s}var u2="1200px",d2="Drag to turn; click, then scroll to zoom; double-click to fit. Keys: arrows, +, \u2212, 0.",sm=2,f2=n=>n.map((t,e)=>({...t,color:t.color??W0(e)})),im=()=>({ink:xn("--ink"),muted:xn("--muted"),page:xn("--page"),faint:xn("--faint")});function p2(n,t){let e=()=>{let i=t.picture(sm);i.className="printed",n.append(i),t.draw()};cy()&&e(),addEventListener("beforeprint",e),addEventListener("afterprint",()=>n.querySelector(".printed")?.remove())}function m2(n,t,e){let i=Xy(Hy(f2(t.layers),t.color_scale)),s=Bv(n,{...t,layers:i},im);ha(s.draw),p2(n,s),Hv(s,t),n.toPng=l=>{let c=s.picture(sm),h=t.color_scale;(h?Vv(c,h,im(),sm):c).toBlob(l,"image/png"),s.draw()};let r=`Not drawn (n/a): ${s.lost} of the items, without all their coordinates.`,o=Wv(s,t.strip),a=Gv(s);a&&(n.toMovie=()=>a.film(n.querySelector("canvas"),im().page)),e.append(...[a?.element,o,s.lost?Js(r):null].filter(Boolean))}function Xv(n){let{compact:t}=n,e=n.caption??"3D view",i=q("div",{class:t?"scene compact":"scene","data-label":e}),s=q("div"),r=()=>{try{m2(i,n,s)}catch(l){i.replaceChildren(Cs(`The 3D view cannot be drawn: ${l.message}`))}};t?vy(i,u2,r):Su(i,r);let o=n.color_scale?kv(n.color_scale):null,a=t?null:q("p",{class:"hint"},d2);return pn("figure",n.caption,i,o,s,a)}var rm=["tight","tighter","tightest"],$v=n=>n.scrollWidth>n.clientWidth+1;function Yv(n){n.classList.remove(...rm,"cards");for(let e of rm){if(!$v(n))return;n.classList.add(e)}let t=n.querySelectorAll("tbody tr").length<=3;$v(n)&&(t||n.clientWidth<560)&&(n.classList.remove(...rm),n.classList.add("cards"))}function qv(n){let t=0;return new ResizeObserver(()=>{!n.clientWidth||n.clientWidth===t||(t=n.clientWidth,Yv(n))}).observe(n),()=>Yv(n)}var om=(n,t)=>n.rows.some(e=>typeof e[t]=="number")&&n.rows.every(e=>e[t]===null||typeof e[t]=="number");function Zv(n){let t=n.highlight_best,e=n.rows.filter(r=>Xt(r[t]));if(t==null||!e.length)return new Set;let i=n.best==="highest"?Math.max:Math.min,s=e.map(r=>r[t]).reduce((r,o)=>i(r,o));return new Set(e.filter(r=>r[t]===s))}function Jv(n,t){let e=t.trim().toLowerCase();return e?n.filter(i=>i.some(s=>String(s??"n/a").toLowerCase().includes(e))):n}var g2=(n,t)=>typeof n=="number"&&typeof t=="number"?n-t:String(n).localeCompare(String(t),void 0,{numeric:!0});function Kv(n,{column:t,descending:e}){if(t===null)return n;let i=n.filter(r=>r[t]!==null),s=n.filter(r=>r[t]===null);return i.sort((r,o)=>g2(r[t],o[t])*(e?-1:1)),[...i,...s]}var jv=15,_2=40,x2=n=>typeof n=="string"&&n.length>_2,y2=({name:n,unit:t})=>t?`${n} [${t}]`:n,v2=(n,t,e,i,s)=>q("td",{class:`${om(n,t)?"number":""} ${i?"best":""} ${x2(e)?"words":""}`,"data-column":y2(n.columns[t])},G0(e,n.columns[t].digits,s),i?q("span",{class:"hidden-words"}," (best)"):null),S2=n=>n.columns.map((t,e)=>Vr(n.rows.map(i=>i[e])));function M2(n,t,e,i){return t.length?t.map(s=>q("tr",{},...s.map((r,o)=>v2(n,o,r,o===n.highlight_best&&e.has(s),i[o])))):[q("tr",{},q("td",{colspan:n.columns.length,class:"empty"},"no rows"))]}function b2(n,t,e){let{name:i,unit:s}=n.columns[t],r=q("button",{type:"button",title:`Sort by ${i}`,onclick:e},i,s?q("span",{class:"unit"},` [${s}]`):null);return q("th",{scope:"col",class:om(n,t)?"number":""},r)}function w2(n){return q("button",{type:"button",onclick:()=>Qr(`${Nl(n.caption,"table")}.csv`,bu(n),"text/csv")},"Save CSV")}var E2=n=>q("input",{type:"search",placeholder:"Search rows","aria-label":"Search rows",oninput:t=>n(t.target.value)});function A2(n,t,e){if(t<=jv)return null;n.classList.add("long","folded");let i=q("button",{type:"button","aria-expanded":"false"},`Show all ${t} rows`);return i.addEventListener("click",()=>{let s=n.classList.toggle("folded");i.textContent=s?`Show all ${t} rows`:`Show the first ${jv} rows`,i.setAttribute("aria-expanded",String(!s)),e()}),i}function T2(n){let t=q("div",{class:"table-box"},n),e=()=>{let i=n.scrollWidth-n.clientWidth-n.scrollLeft;t.classList.toggle("goes-left",n.scrollLeft>1),t.classList.toggle("goes-right",i>1)};return n.addEventListener("scroll",e,{passive:!0}),new ResizeObserver(e).observe(n),t}function Qv(n){let t=Zv(n),e=S2(n),i={column:null,descending:!1,text:""},s=q("tbody"),r=()=>s.replaceChildren(...M2(n,Kv(Jv(n.rows,i.text),i),t,e)),o=u=>{i.descending=i.column===u&&!i.descending,i.column=u,a.forEach((d,f)=>d.setAttribute("aria-sort",f!==u?"none":i.descending?"descending":"ascending")),r()},a=n.columns.map((u,d)=>b2(n,d,()=>o(d))),l=q("div",{class:"table-frame",tabindex:0,role:"region","aria-label":n.caption??"Table"},q("table",{},q("thead",{},q("tr",{},...a)),s));r();let c=qv(l),h=q("div",{class:"tools"},n.search?E2(u=>{i.text=u,r(),c()}):null,A2(l,n.rows.length,c),w2(n));return pn("table",n.caption,T2(l),h)}var Vl=2.4477,Vi=n=>Array.isArray(n)&&n.every(Xt);function C2(n,t){let e=(i,s)=>Vi(i)?Vi(s)?[i[t]-Vl*s[t],i[t]+Vl*s[t]]:[i[t]]:[];return[0,...n.arrows.flatMap(i=>[...e(i.measured,i.sd),...e(i.predicted,i.predicted_sd)])]}var tS=n=>[0,1].map(t=>Ei(n.panels.flatMap(e=>C2(e,t)),.08));function eS(n,t,e){let i=s=>Math.max(...n.map(r=>r[s][1]-r[s][0]));return Math.min(t/i(0),e/i(1))}var Fu=({measured:n,predicted:t})=>Vi(n)&&Vi(t)?Math.hypot(n[0]-t[0],n[1]-t[1]):null,nS=n=>[...new Set(n.planes.flatMap(t=>t.panels.flatMap(e=>e.arrows.map(i=>i.group))))];var R2=7;function iS(n,t,e){let i=e[0]-t[0],s=e[1]-t[1],r=Math.hypot(i,s);if(r<.5)return[ct("circle",{class:n,cx:e[0],cy:e[1],r:2})];let o=Math.min(R2,.6*r),a=i/r,l=s/r,c=[e[0]-o*a,e[1]-o*l],h=u=>`${c[0]-u*.4*o*l},${c[1]+u*.4*o*a}`;return[ct("line",{class:n,x1:t[0],y1:t[1],x2:c[0],y2:c[1]}),ct("polygon",{class:n,points:`${e[0]},${e[1]} ${h(1)} ${h(-1)}`})]}var am=(n,{x:t,y:e},i,s)=>!Vi(i)||!Vi(s)?[]:[ct("ellipse",{class:n,cx:t(i[0]),cy:e(i[1]),rx:Vl*Math.abs(t(s[0])-t(0)),ry:Vl*Math.abs(e(s[1])-e(0))})];var qn={left:46,right:8,top:24,bottom:38};function P2([n,t],e){let i=e*(n[1]-n[0]),s=e*(t[1]-t[0]);return{x:gn(n,[qn.left,qn.left+i]),y:gn(t,[qn.top+s,qn.top]),width:i,height:s}}function I2({x:n,y:t,width:e,height:i},[s,r],o){let a=_=>Math.max(2,Math.round(_/32)),l=qn.top+i,c=(_,g,p,v,T)=>ct("line",{class:_,x1:g,y1:p,x2:v,y2:T}),h=si(...s,a(e)),u=si(...r,a(i)),d=[gs(h),gs(u)],f=h.flatMap((_,g)=>[c(_===0?"zero":"grid",n(_),qn.top,n(_),l),ct("text",{x:n(_),y:l+13,"text-anchor":"middle"},d[0][g])]),m=u.flatMap((_,g)=>[c(_===0?"zero":"grid",qn.left,t(_),qn.left+e,t(_)),ct("text",{x:qn.left-5,y:t(_)+3.5,"text-anchor":"end"},d[1][g])]);return[...f,...m,ct("text",{class:"label",x:qn.left+e/2,y:l+29,"text-anchor":"middle"},o.x_label??""),ct("text",{class:"label","text-anchor":"middle",transform:`translate(11 ${qn.top+i/2}) rotate(-90)`},o.y_label??"")]}var sS=(n,t)=>(Vi(n)?`(${Ot(n[0])}, ${Ot(n[1])})`:"n/a")+(Vi(t)?`, sd (${Ot(t[0])}, ${Ot(t[1])})`:""),L2=(n,t)=>[`${n.group}, ${t}`,`measured ${sS(n.measured,n.sd)}`,`predicted ${sS(n.predicted,n.predicted_sd)}`,`difference ${Ot(Fu(n))}`];function D2(n,t,e,i){let s=[e.x(0),e.y(0)],r=(l,c)=>Vi(c)?iS(l,s,[e.x(c[0]),e.y(c[1])]):[],o=l=>Vi(l)?[ct("line",{class:"catch",x1:s[0],y1:s[1],x2:e.x(l[0]),y2:e.y(l[1])})]:[],a=ct("g",{class:"pair","data-group":n.group,style:`color: ${hi(t)}`,tabindex:0,role:"img"},...am("interval",e,n.measured,n.sd),...am("interval dashed",e,n.predicted,n.predicted_sd),...r("measured",n.measured),...r("predicted",n.predicted),...o(n.measured),...o(n.predicted));return Fi(a,L2(n,i))}function rS(n,t,e,i,s){let r=P2(e,i),o=r.width+qn.left+qn.right,a=r.height+qn.top+qn.bottom;return ct("svg",{class:"plot vector-panel",width:o,height:a,viewBox:`0 0 ${o} ${a}`},ct("text",{class:"title",x:qn.left,y:14},n.title),...I2(r,e,t),...n.arrows.map(l=>D2(l,s.get(l.group),r,n.title)))}var oS={width:250,height:240},N2=168,aS=[{name:"measured",mark:"line"},{name:"predicted",mark:"dash"},{name:"95 % region",mark:"ring"}],U2=(n,t,e,i)=>q("div",{class:"plane"},q("h3",{},n.name),q("div",{class:"panels"},...n.panels.map(s=>rS(s,n,t,e,i))));function lS(n){let t=nS(n),e=bl(t),i=n.planes.map(tS),s=n.planes.some(u=>u.panels.length>3)?N2:oS.width,r=eS(i,s,oS.height),o=q("div",{class:"planes"},...n.planes.map((u,d)=>U2(u,i[d],r,e))),a=(u,d)=>o.querySelectorAll(".pair").forEach(f=>{f.dataset.group===u&&(f.style.display=d?"":"none")}),l=n.planes.flatMap(u=>u.panels.flatMap(d=>d.arrows)),c=l.filter(u=>Fu(u)===null).length,h=l.some(u=>u.sd||u.predicted_sd);return pn("figure",n.caption,gr(t.map(u=>({name:u,color:hi(e.get(u))})),a),_r(h?aS:aS.slice(0,2)),o,Js(c?`${c} of ${l.length} pairs have a force that is not available (n/a).`:""))}var O2=({file:n,text:t})=>Dl(n)?q("p",{},q("a",{href:n},t??n)):null,F2=n=>q("div",{class:"prose"},...Yl(n.text),n.link?O2(n.link):null),B2=({narrow:n,blocks:t})=>q("div",{class:n?"row narrow":"row"},...t.map(lm)),z2={table:Qv,lines:My,vectors:lS,scene:Xv,bars:Y0,interval:b_,banner:z0,chains:s_,corner:x_,predictive:Ry,text:F2,row:B2};function lm(n){let t=O0(n);if(t.length)return Cs(t.join("; "));if(U0(n))return pn("figure",n.caption,Js("No data."));try{return ky(n,z2[n.type](n))}catch(e){return Cs(`block "${n.type}" could not be drawn: ${e.message}`)}}var k2=10,V2=2,ma=n=>n.querySelector(":scope > .section-body"),G2=n=>n.querySelector(":scope > h2 > .fold"),hS=n=>ma(n).hasAttribute("hidden");function br(n,t){t?ma(n).setAttribute("hidden","until-found"):ma(n).removeAttribute("hidden"),n.classList.toggle("is-folded",t),G2(n).setAttribute("aria-expanded",String(!t))}var uS=(n,...t)=>q("h2",{},q("button",{type:"button",class:"fold","aria-expanded":"true",title:"Fold or open this section",onclick:e=>{let i=e.currentTarget.closest("section");br(i,!hS(i))}},n),...t),dS=n=>n.length>1&&document.getElementById(n.slice(1))?.closest("section");function cS(){let n=dS(location.hash);!n||!ma(n)||(br(n,!1),n.scrollIntoView())}function H2(n){let t=[];addEventListener("beforeprint",()=>{t=n.filter(hS),t.forEach(e=>br(e,!1))}),addEventListener("afterprint",()=>t.forEach(e=>br(e,!0)))}function fS(n){H2(n),addEventListener("hashchange",cS),document.addEventListener("click",e=>{let i=e.target.closest?.("a[href^='#']")?.getAttribute("href"),s=i&&dS(i);s&&ma(s)&&br(s,!1)});for(let e of n)ma(e).addEventListener("beforematch",()=>br(e,!1));if(n.length>=k2&&n.slice(V2).forEach(e=>br(e,!0)),requestAnimationFrame(cS),n.length<2)return null;let t=e=>()=>n.forEach(i=>br(i,e));return q("div",{class:"tools"},q("button",{type:"button",onclick:t(!1)},"Open all"),q("button",{type:"button",onclick:t(!0)},"Fold all"))}var W2=n=>n.includes(": ")?n.slice(0,n.indexOf(": ")):null,pS=n=>n.charAt(0).toUpperCase()+n.slice(1);function mS(n){let t=[];return n.forEach((e,i)=>{let s=W2(e),r=t.at(-1);s!==null&&r?.name===s?r.entries.push({title:pS(e.slice(s.length+2)),index:i}):t.push({name:s,entries:[{title:pS(e.slice((s?.length??-2)+2)),index:i}]})}),t.map(({name:e,entries:i})=>i.length>1?{title:e,entries:i}:{title:n[i[0].index],index:i[0].index})}function X2(n){return n.filter(e=>e.getBoundingClientRect().top<innerHeight/3).at(-1)??n[0]}function $2(n,t){let e=null,i=()=>{let s=n[t.indexOf(X2(t))];if(s.hasAttribute("aria-current"))return;n.forEach(o=>o.toggleAttribute("aria-current",o===s));let r=s.closest("details");e&&e!==r&&(e.open=!1),r&&(r.open=!0),e=r};addEventListener("scroll",i,{passive:!0}),requestAnimationFrame(i)}function Y2(n,t){let e=q("button",{type:"button",class:"contents-switch"}),i=r=>{t.hidden=!r,n.classList.toggle("no-contents",!r),e.setAttribute("aria-expanded",String(r)),e.title=r?"Put the contents away":"Show the contents",e.textContent=r?"Contents \u2039":"\u203A Contents"};e.addEventListener("click",()=>i(t.hidden));let s=matchMedia("(max-width: 1100px)");return s.addEventListener("change",()=>i(!s.matches)),i(!s.matches),e}function gS(n,t,e,i,s){let r=t.map(({id:h})=>q("a",{href:`#${h}`})),o=({index:h,title:u})=>(r[h].textContent=u,q("li",{},r[h])),a=mS(t.map(({title:h})=>h)).map(h=>h.entries?q("li",{},q("details",{},q("summary",{},h.title),q("ol",{},...h.entries.map(o)))):o(h));r.length&&$2(r,e);let l=s?q("p",{},"On this page"):null,c=q("div",{class:"contents-list"},s,l,q("ol",{},...a),i);return q("nav",{class:"contents","aria-label":"Contents"},Y2(n,c),c)}var q2=n=>q("header",{class:"heading"},q("h1",{},n.title),n.subtitle?q("p",{class:"subtitle"},n.subtitle):null),Z2=({id:n,title:t,text:e})=>q("section",{id:n,"aria-label":t},uS(t,q("a",{class:"anchor",href:`#${n}`,"aria-label":`Link to ${t}`},"#")),q("div",{class:"section-body"},q("div",{class:"prose"},...Yl(e))));function J2(n){for(let t of["figure","table"])n.querySelectorAll(`.${t}-caption`).forEach((e,i)=>e.setAttribute("data-number",i+1))}function K2(n){let t=Object.entries(n??{}).flatMap(([e,i])=>[q("dt",{},...$l(e)),q("dd",{},String(i??"n/a"))]);return q("footer",{},q("details",{},q("summary",{},`Provenance (${t.length/2} entries)`),t.length?q("dl",{},...t):q("p",{},"This report carries no provenance.")))}function _S(n,t){if(!Array.isArray(t.sections))throw new Error('"sections" is missing');document.title=t.title??"thenar report";let e=t.sections.map(Z2),i=fS(e);vf(t).sections.forEach(({blocks:s=[]},r)=>e[r].lastElementChild.append(...s.map(lm))),n.replaceChildren(q2(t),gS(n,t.sections,e,i,Ey(t.pages,t.file)),q("div",{class:"sections"},by(t.opening)??"",wy(t.summary)??"",...e.length?e:[Cs("This report has no sections.")],Ay(t.pages,t.file)??""),K2(t.provenance)),J2(n)}var xS=document.getElementById("report");function j2(){let n=document.getElementById("thenar-report");if(!n)throw new Error("the page has no element thenar-report");return JSON.parse(n.textContent)}try{hy(),_S(xS,j2())}catch(n){xS.replaceChildren(Cs(`The report cannot be shown: ${n.message}`))}})();
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
